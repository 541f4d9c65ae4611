// mansard vary
#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "cli/derive_all.hpp"
#include "cli/output.hpp"
#include "cli/picture.hpp"
#include "cli/progress.hpp"
#include "cli/remarks.hpp"
#include "cli/vary_axes.hpp"
#include "cli/vary_export.hpp"
#include "grammar/utf8.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/properties.hpp"
#include "render/sheet.hpp"

namespace mansard {
namespace {

namespace fs = std::filesystem;

constexpr PictureSize usual_cell{400, 300};
constexpr int largest_side = 16000;

std::u32string unicode(std::string_view text) {
  std::u32string characters;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint c = decode(text, at);
    characters += c.value;
    at += c.bytes;
  }
  return characters;
}

class Vary {
 public:
  Vary(Session& session, const Arguments& arguments)
      : session_(session),
        arguments_(arguments),
        keep_going_(arguments.has("--keep-going")),
        out_(picture_output(arguments)),
        remarks_(session) {
    sheet_.cell = picture_options(arguments, usual_cell);
    sheet_.font = MANSARD_FONT;
  }

  int run();

 private:
  struct Cell {
    Scene scene;
    std::string problem;  ///< empty, or why there is no scene
  };

  bool load();
  void lay_out();
  void make_children();
  bool derive_cell(std::size_t number);
  std::unique_ptr<Program> compiled(const Child& child, Cell& cell);
  const std::string& caption(const Cell& cell) const;
  void fail(Cell& cell, Diagnostic diagnostic);
  void derive_program(const Program& program, const Child& child, Cell& cell);
  void note_stronger(const Program& program);
  void note_misnamed(const Program& program);
  void note_alike() const;
  void draw();

  Session& session_;
  const Arguments& arguments_;
  const bool keep_going_;
  const std::string out_;
  SheetOptions sheet_;
  Variations variations_;
  std::vector<Child> children_;
  StoredSet set_;
  std::unique_ptr<Export> export_;
  std::vector<Cell> cells_;
  std::size_t failed_ = 0;
  bool interrupted_ = false, told_stronger_ = false;
  std::optional<std::vector<Diagnostic>> misnamed_;  ///< properties, in all styles so far
  Remarks remarks_;
};

int Vary::run() {
  if (!load()) return exit_input;
  lay_out();
  make_children();
  if (const auto folder = arguments_.value("--export"))
    export_ = std::make_unique<Export>(*folder, children_, session_.library());
  {
    Progress progress(children_.size(), session_.quiet());
    for (std::size_t i = 0; i < children_.size(); ++i) {
      if (!derive_cell(i)) return interrupted_ ? 130 : exit_input;
      progress.step();
    }
  }
  if (misnamed_) std::ranges::for_each(*misnamed_, [&](const auto& d) { session_.print(d); });
  note_alike();
  draw();
  if (export_) {
    const std::size_t count = export_->finish();
    session_.say(
        (count == 1 ? "1 model and style: " : std::to_string(count) + " models and styles: ") +
        *arguments_.value("--export"));
  }
  session_.say(count_text(cells_.size(), "variation") + ": " + out_ +
               session_.style_taken(arguments_));
  return failed_ > 0 ? exit_input : exit_done;
}

bool Vary::load() {
  Diagnostics diagnostics;
  const std::string& script = arguments_.positional()[0];
  const bool read = session_.library().load(script, diagnostics) != nullptr;
  diagnostics.sort();
  remarks_.print(diagnostics.all());
  if (!read || diagnostics.has_errors()) return false;
  Diagnostics warnings;
  variations_ = variations_of(arguments_, session_.library(), warnings);
  set_ = stored_footprints(session_, arguments_.positional()[1], arguments_, failed_);
  if (set_.footprints.size() > 0) return true;
  Diagnostic d;
  d.text = "there is no footprint to derive";
  throw Failure(std::move(d));
}

void Vary::lay_out() {
  const std::size_t count = variations_.all.size();
  sheet_.columns = variations_.columns > 0
                       ? variations_.columns
                       : sheet_columns(count, sheet_.cell.width, sheet_.cell.height);
  const std::string& what = arguments_.positional()[1];
  std::error_code error;
  const bool is_file = fs::exists(what, error);
  std::string on = is_file ? fs::path(what).filename().string() : what;
  if (set_.footprints.size() > 1) {
    on = std::to_string(set_.footprints.size()) + " footprints of " + on;
  } else if (is_file) {
    Footprint room;
    on += ", " + set_.footprints.get(0, room).id;
  }
  sheet_.title = unicode(variations_.common + " on " + on);
  const SheetSize size = sheet_size(count, sheet_);
  if (size.width > largest_side || size.height > largest_side)
    throw UsageError(std::to_string(count) + " pictures of " + std::to_string(sheet_.cell.width) +
                     "x" + std::to_string(sheet_.cell.height) + " make a sheet of " +
                     std::to_string(size.width) + "x" + std::to_string(size.height) +
                     " pixels: give a smaller --size, the size of each picture");
}

/// The children import the script as they would from their folder, so that what is derived here is
/// what their files derive.
void Vary::make_children() {
  const fs::path script = arguments_.positional()[0];
  const auto plain = [](const fs::path& path) { return fs::absolute(path).lexically_normal(); };
  const auto folder = arguments_.value("--export");
  const fs::path import = folder ? plain(script).lexically_relative(plain(*folder)) : script;
  for (std::size_t i = 0; i < variations_.all.size(); ++i) {
    children_.push_back(
        child_of(variations_.all[i], i + 1, import.generic_string(), session_.library()));
  }
  cells_.resize(children_.size());
}

/// False when all must end: a failure without --keep-going, or Ctrl-C.
bool Vary::derive_cell(std::size_t number) {
  Cell& cell = cells_[number];
  const Child& child = children_[number];
  if (const auto program = compiled(child, cell)) {
    note_stronger(*program);
    note_misnamed(*program);
    derive_program(*program, child, cell);
  }
  if (interrupted_) session_.say("interrupted: nothing was written");
  if (!cell.problem.empty()) ++failed_;
  return !interrupted_ && (cell.problem.empty() || keep_going_);
}

std::unique_ptr<Program> Vary::compiled(const Child& child, Cell& cell) {
  Diagnostics diagnostics;
  CompileOptions options;
  options.style = child.style;
  const std::string path = export_ ? export_->script_path(child) : child.stem + ".style";
  session_.library().add(path, child.text, diagnostics);
  std::unique_ptr<Program> program;
  if (!diagnostics.has_errors())
    program = compile(session_.library(), session_.meshes(), options, diagnostics);
  diagnostics.sort();
  for (const Diagnostic& d : diagnostics.all()) {
    if (d.severity == Severity::error) {
      fail(cell, d);
    } else {
      remarks_.print({&d, 1});
    }
  }
  return program;
}

const std::string& Vary::caption(const Cell& cell) const {
  return variations_.all[static_cast<std::size_t>(&cell - cells_.data())].caption;
}

void Vary::fail(Cell& cell, Diagnostic diagnostic) {
  if (cell.problem.empty()) cell.problem = diagnostic.text;
  diagnostic.notes.push_back({"in the picture '" + caption(cell) + "'", {}});
  session_.print(diagnostic);
}

void Vary::derive_program(const Program& program, const Child& child, Cell& cell) {
  DeriveOptions options = derive_options(arguments_, program);
  options.seed = program.styles[program.main_style].linked->seed.value_or(0);  // the child says it
  const std::vector<std::string_view> symbols = symbol_names(program);
  Looks looks(program);
  std::unique_ptr<SurfaceWriter> model;
  if (export_)
    model = write_obj(export_->model_path(child), Up::y, model_comment(program, set_, options));
  const Totals totals =
      derive_all(program, session_.meshes(), set_.footprints, options, sheet_.cell.threads,
                 keep_going_, {.number = [&](Derived& derived) {
                   Building& building = derived.building;
                   remarks_.add(building);
                   if (derived.error) return fail(cell, *derived.error);
                   looks.adopt(building);
                   cell.scene.add(building.surface);
                   if (model) model->add({building.id, &building.surface}, symbols, looks.all());
                 }});
  cell.scene.paints = looks.paints();
  remarks_.finish(program, "in the picture '" + caption(cell) + "' ");
  interrupted_ = totals.interrupted;
  if (model && cell.problem.empty()) export_->add(child, std::move(model), looks.all());
}

/// A rule's set() and a footprint's property are stronger than what a style says.
void Vary::note_stronger(const Program& program) {
  if (std::exchange(told_stronger_, true)) return;
  for (const Change& change : variations_.all[0].changes) {
    const bool is_set = std::ranges::any_of(program.variables, [&](const VariableSlot& slot) {
      return slot.name == change.name && slot.settable;
    });
    const bool is_property =
        std::ranges::find(set_.properties, change.name) != set_.properties.end();
    if (!is_set && !is_property) continue;
    session_.say("note: '" + change.name + "' is also given by " +
                 (is_set ? "set() in a rule" : "a footprint's property") +
                 ", which is stronger than what a style says");
  }
}

/// A property may be for another of the styles.
void Vary::note_misnamed(const Program& program) {
  const std::vector<Diagnostic> found = misnamed_properties(program, set_.properties);
  if (!misnamed_) misnamed_ = found;
  std::erase_if(*misnamed_, [&](const Diagnostic& d) {
    return std::ranges::find(found, d.text, &Diagnostic::text) == found.end();
  });
}

void Vary::note_alike() const {
  const auto is_first = [&](const Cell& cell) {
    const Scene &a = cells_[0].scene, &b = cell.scene;
    const auto same_paint = [](const Paint& x, const Paint& y) {
      return x.color == y.color && x.texture == y.texture && x.glass == y.glass;
    };
    return cell.problem.empty() && a.points == b.points && a.paint == b.paint &&
           std::ranges::equal(a.paints, b.paints, same_paint);
  };
  if (cells_.size() < 2 || !std::ranges::all_of(cells_, is_first)) return;
  session_.say("note: all " + std::to_string(cells_.size()) +
               " variations are alike: nothing that was derived depends on what differs");
}

void Vary::draw() {
  std::vector<SheetCell> cells;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Cell& cell = cells_[i];
    const bool is_drawn = cell.problem.empty() || !cell.scene.points.empty();
    cells.push_back({is_drawn ? &cell.scene : nullptr, unicode(variations_.all[i].caption),
                     unicode(cell.problem)});
  }
  Progress progress(cells.size(), session_.quiet());
  const auto sheet = draw_sheet(cells, sheet_, [&] { progress.step(); });
  if (!sheet) {
    Diagnostic d;
    d.text = "can not read the font '" + sheet_.font + "' for the captions";
    d.help = "install it: apt-get install fonts-dejavu-core";
    throw Failure(std::move(d));
  }
  write_picture(*sheet, out_);
}

}  // namespace

int run_vary(const Arguments& arguments) {
  Session session(arguments);
  Vary vary(session, arguments);
  return session.guard([&] { return vary.run(); });
}

}  // namespace mansard
