-- Run by test_neovim.py inside Neovim: drives the real server through vim.lsp with the set-up that users have.
-- Writes a line of JSON for each step into the file MANSARD_SAID.
local said = assert(io.open(os.getenv("MANSARD_SAID"), "w"))

local function say(what, value)
  said:write(vim.fn.json_encode({ what, value }) .. "\n")
  said:flush()
end

local function wait(what, condition)
  if not vim.wait(30000, condition, 20) then
    say("timeout", what)
    vim.cmd("cquit 1")
  end
end

local function cursor_to(needle, column)
  local at = vim.fn.searchpos("\\V" .. vim.fn.escape(needle, "\\"), "w")
  vim.api.nvim_win_set_cursor(0, { at[1], at[2] - 1 + (column or 0) })
end

local function place()
  local at = vim.api.nvim_win_get_cursor(0)
  return { vim.fn.expand("%:t"), at[1], vim.fn.expand("<cword>") }
end

local function messages()
  local all = {}
  for _, d in ipairs(vim.diagnostic.get(0)) do
    table.insert(all, { d.lnum + 1, d.severity, vim.split(d.message, "\n")[1] })
  end
  return all
end

local function highlight(needle, column)
  cursor_to(needle, column)
  local at = vim.api.nvim_win_get_cursor(0)
  return vim.fn.synIDattr(vim.fn.synID(at[1], at[2] + 1, 1), "name")
end

local function session()
  require("mansard").setup({ cmd = { os.getenv("MANSARD"), "lsp" } })
  vim.cmd("edit heir.style")
  local buffer = vim.api.nvim_get_current_buf()
  say("filetype", vim.bo.filetype)
  wait("a client", function()
    local clients = vim.lsp.buf_get_clients(buffer)
    return next(clients) ~= nil and select(2, next(clients)).initialized
  end)

  say("highlight", {
    highlight("style Heir"), highlight("Heir"), highlight("WindowWidth"), highlight("comp"),
    highlight("TILE ->"), highlight("side :"), highlight("// a comment"), highlight("super"),
  })

  wait("diagnostics", function() return #vim.diagnostic.get(0) > 0 end)
  say("broken", messages())
  cursor_to("extruda")
  vim.cmd("normal! ciwextrude")
  wait("no diagnostics", function() return #vim.diagnostic.get(0) == 0 end)
  say("mended", messages())

  cursor_to("WindowWidth)")
  vim.lsp.buf.definition()
  wait("the definition", function() return place()[2] ~= 6 end)
  say("definition", place())
  vim.lsp.buf.declaration()
  wait("the declaration", function() return place()[1] == "house.style" end)
  say("declaration", place())
  vim.cmd("silent update | buffer heir.style")

  cursor_to("WindowWidth)")
  vim.lsp.buf.hover()
  local function floating()
    for _, window in ipairs(vim.api.nvim_list_wins()) do
      if vim.api.nvim_win_get_config(window).relative ~= "" then
        return window
      end
    end
  end
  wait("hover", floating)
  say("hover", vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(floating()), 0, -1, false))
  vim.api.nvim_win_close(floating(), true)

  local answers = vim.lsp.buf_request_sync(0, "textDocument/completion",
    vim.lsp.util.make_position_params(), 30000)
  local labels = {}
  for _, answer in pairs(answers) do
    for _, item in ipairs(answer.result) do
      labels[item.label] = true
    end
  end
  say("completion", { labels.WindowWidth or false, labels.Height or false, labels.min or false })

  vim.lsp.buf.rename("PaneWidth")
  wait("the rename", function() return vim.fn.search("PaneWidth", "nw") > 0 end)
  vim.cmd("silent wall")
  say("renamed", { vim.fn.readfile("house.style"), vim.fn.readfile("heir.style") })

  vim.api.nvim_buf_set_lines(0, -1, -1, false, { "style   Late:Heir{}" })
  vim.lsp.buf.formatting_sync(nil, 30000)
  say("formatted", vim.api.nvim_buf_get_lines(0, -2, -1, false))
end

local sound, problem = pcall(session)
if not sound then
  say("failed", tostring(problem))
  vim.cmd("cquit 1")
end
vim.cmd("qall!")
