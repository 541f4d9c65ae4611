// mansard derive
#include <chrono>
#include <optional>
#include <vector>

#include "cli/derive_all.hpp"
#include "cli/models.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/remarks.hpp"
#include "cli/report.hpp"

namespace mansard {
namespace {

/// A model on its way.
struct Level {
  Level(const Program& program, const ModelTarget& t, const ModelOptions& options,
        const std::string& comment)
      : target(t), writer(open_model(t.path, options, comment)), looks(program), report(program) {}

  ModelTarget target;
  std::unique_ptr<SurfaceWriter> writer;
  Looks looks;
  Report report;
  double seconds = 0;
  std::size_t bytes = 0;
};

class Derive {
 public:
  Derive(Session& session, const Arguments& arguments, const ModelOptions& models)
      : session_(session),
        arguments_(arguments),
        models_(models),
        keep_going_(arguments.has("--keep-going")),
        remarks_(session) {}
  int run();

 private:
  Totals derive(Level& level);
  void prepare(const Level& level, Derived& derived) const;
  void number(Level& level, Derived& derived);
  void write_all();
  void leave_out_failed();

  Session& session_;
  const Arguments& arguments_;
  const ModelOptions& models_;
  const bool keep_going_;
  Remarks remarks_;
  StoredSet set_;
  std::vector<std::string_view> symbols_;
  std::vector<Level> levels_;
  std::vector<std::size_t> failed_;  ///< numbers, of the level that was derived
};

int Derive::run() {
  const Program& program = session_.program();
  std::size_t left_out = 0;
  set_ = stored_footprints(session_, arguments_.positional()[1], arguments_, left_out);
  const DeriveOptions options = derive_options(arguments_, program, models_.targets.front().lod);
  const std::string comment = model_comment(program, set_, options);
  for (const ModelTarget& target : models_.targets)
    levels_.emplace_back(program, target, models_, comment).report.dropped = set_.small.size();
  std::optional<OutputFile> report_file;  // a folder that is missing is said before the work
  if (const auto path = arguments_.value("--report")) report_file.emplace(*path);
  symbols_ = symbol_names(program);
  for (Level& level : levels_) {
    const Totals totals = derive(level);
    if (totals.interrupted) {
      session_.say("interrupted: nothing was written");
      return 130;
    }
    if (totals.failed > 0 && !keep_going_) return exit_input;
    left_out += totals.failed;
    leave_out_failed();
  }
  write_all();
  if (report_file) {
    std::vector<LevelReport> reports;
    for (const Level& level : levels_)
      reports.push_back(
          {level.target.lod, level.target.path, level.bytes, level.seconds, &level.report});
    levels_.front().report.write(*report_file, reports);
  }
  remarks_.finish(program);
  if (left_out > 0)
    session_.say(std::to_string(left_out) +
                 (left_out == 1 ? " footprint was" : " footprints were") + " left out");
  return left_out > 0 ? exit_input : exit_done;
}

Totals Derive::derive(Level& level) {
  const auto started = std::chrono::steady_clock::now();
  Progress progress(set_.footprints.size(), session_.quiet());
  const Steps steps{.prepare = [&](Derived& derived) { prepare(level, derived); },
                    .number =
                        [&](Derived& derived) {
                          progress.step();
                          number(level, derived);
                        },
                    .format = [](Derived& derived) { derived.piece->format(); },
                    .append = [](Derived& derived) { derived.piece->append(); }};
  const Totals totals = derive_all(session_.program(), session_.meshes(), set_.footprints,
                                   derive_options(arguments_, session_.program(), level.target.lod),
                                   thread_option(arguments_), keep_going_, steps);
  level.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return totals;
}

/// On any thread.
void Derive::prepare(const Level& level, Derived& derived) const {
  if (!derived.piece) derived.piece = level.writer->new_piece();
  const Program& program = session_.program();
  const Building& building = derived.building;
  derived.faces.count(building.surface, program.stain_look);
  derived.piece->prepare({building.id, &building.surface, program.styles[program.main_style].name,
                          derived.footprint->properties});
}

/// In order: all that is said, and all that is counted.
void Derive::number(Level& level, Derived& derived) {
  Building& building = derived.building;
  if (&level == &levels_.front()) remarks_.add(building);
  if (derived.error) {
    session_.print(*derived.error);
    failed_.push_back(derived.number);
    return level.report.add_failure(building.id, *derived.error);
  }
  level.looks.adopt(building);
  level.report.add(building, derived.faces, derived.footprint->polygon);
  derived.piece->number(symbols_, level.looks.all());
}

/// What failed at one level of detail is not tried at the next ones.
void Derive::leave_out_failed() {
  std::vector<uint32_t> kept;
  for (uint32_t number = 0, next = 0; number < set_.footprints.size(); ++number) {
    if (next < failed_.size() && failed_[next] == number) {
      ++next;
    } else {
      kept.push_back(number);
    }
  }
  set_.footprints.keep(kept);
  failed_.clear();
}

/// When all are derived: a chain appears whole or not at all, but for a full disk.
void Derive::write_all() {
  for (Level& level : levels_) {
    level.bytes = level.writer->finish(level.looks.all());
    const Report& report = level.report;
    session_.say(std::to_string(report.buildings) +
                 (report.buildings == 1 ? " building, " : " buildings, ") +
                 std::to_string(report.shapes) + " shapes, " + std::to_string(report.polygons) +
                 " polygons, " + std::to_string(level.bytes / 1000) + " kB: " + level.target.path +
                 session_.style_taken(arguments_));
  }
}

}  // namespace

int run_derive(const Arguments& arguments) {
  Session session(arguments);
  const ModelOptions models = model_options(arguments);
  return session.guard([&]() -> int {
    if (!session.compile(arguments.positional()[0], compile_options(arguments))) return exit_input;
    return Derive(session, arguments, models).run();
  });
}

}  // namespace mansard
