-- Connects `.style` scripts to `mansard lsp`. Neovim 0.7 or later, no other plugin.
--
--   require("mansard").setup({ cmd = { "mansard", "lsp" }, mappings = true })
local M = {}

-- Only what the options do not say.
local defaults = { cmd = { "mansard", "lsp" }, mappings = true, on_attach = nil }

local function map_keys(buffer)
  local function map(keys, action, what)
    vim.keymap.set("n", keys, action, { buffer = buffer, desc = what })
  end
  map("K", vim.lsp.buf.hover, "what this is")
  map("gd", vim.lsp.buf.definition, "definition")
  map("gD", vim.lsp.buf.declaration, "what this overrides")
  map("gi", vim.lsp.buf.implementation, "what overrides this")
  map("gr", vim.lsp.buf.references, "all uses")
  map("<leader>rn", vim.lsp.buf.rename, "rename")
  map("<leader>ca", vim.lsp.buf.code_action, "mend")
end

-- The folder of the repository, else that of the script.
local function root_of(buffer)
  local folder = vim.fn.fnamemodify(vim.api.nvim_buf_get_name(buffer), ":p:h")
  local at = folder
  while true do
    if vim.fn.isdirectory(at .. "/.git") == 1 then
      return at
    end
    local parent = vim.fn.fnamemodify(at, ":h")
    if parent == at then
      return folder
    end
    at = parent
  end
end

local clients = {} -- by root folder

local function attach(buffer, options)
  local root = root_of(buffer)
  local id = clients[root]
  if not id or not vim.lsp.get_client_by_id(id) then
    id = vim.lsp.start_client({
      name = "mansard",
      cmd = options.cmd,
      root_dir = root,
      workspace_folders = { { uri = vim.uri_from_fname(root), name = root } },
      on_attach = options.on_attach,
    })
    clients[root] = id
  end
  if not id then
    return
  end
  vim.lsp.buf_attach_client(buffer, id)
  vim.api.nvim_buf_set_option(buffer, "omnifunc", "v:lua.vim.lsp.omnifunc")
  if options.mappings then
    map_keys(buffer)
  end
end

function M.setup(given)
  local options = vim.tbl_extend("force", defaults, given or {})
  vim.api.nvim_create_autocmd("FileType", {
    group = vim.api.nvim_create_augroup("mansard", { clear = true }),
    pattern = "mansard",
    callback = function(event)
      attach(event.buf, options)
    end,
  })
end

return M
