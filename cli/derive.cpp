// mansard derive
#include <chrono>
#include <filesystem>

#include "cli/derive_all.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/remarks.hpp"
#include "cli/report.hpp"

namespace mansard {
namespace {

struct Job {
  Session& session;
  const Arguments& arguments;
  std::string out;
};

Up up_of(const Arguments& arguments) {
  const std::string up = arguments.text("--up", "y");
  if (up != "y" && up != "z") throw UsageError("--up takes y or z, not '" + up + "'");
  return up == "y" ? Up::y : Up::z;
}

std::string output_of(const Arguments& arguments) {
  const auto out = arguments.value("--output");
  if (!out) throw UsageError("say where the model goes: -o OUT.obj or OUT.glb");
  for (const char* const ending : {".obj", ".glb", ".gltf"}) {
    if (out->ends_with(ending)) return *out;
  }
  throw UsageError("'" + *out + "' has no ending that is written: .obj, .glb or .gltf");
}

std::unique_ptr<SurfaceWriter> writer_of(const Job& job, const std::string& comment) {
  if (job.out.ends_with(".obj")) return write_obj(job.out, up_of(job.arguments), comment);
  if (up_of(job.arguments) == Up::z) throw UsageError("--up z is for .obj: glTF is always y up");
  return write_gltf(job.out, comment);
}

/// Nothing that is read is written over, and the report not over the model.
void refuse_own_input(const Arguments& arguments, const std::string& out) {
  std::vector<std::pair<std::string, std::string>> targets{{"-o", out}};
  if (const auto report = arguments.value("--report")) targets.emplace_back("--report", *report);
  for (const auto& [flag, target] : targets) {
    for (const std::string& input : arguments.positional()) {
      std::error_code missing;
      if (std::filesystem::equivalent(input, target, missing))
        throw UsageError(flag + " " + target + " would write over what is read from '" + input +
                         "': give it another name");
    }
  }
  if (targets.back().first != "-o" && targets.back().second == out)
    throw UsageError("--report and -o name the same file: '" + out + "'");
}

std::string summary(const Report& report, std::size_t bytes, const std::string& out) {
  return std::to_string(report.buildings) +
         (report.buildings == 1 ? " building, " : " buildings, ") + std::to_string(report.shapes) +
         " shapes, " + std::to_string(report.polygons) + " polygons, " +
         std::to_string(bytes / 1000) + " kB: " + out;
}

int derive(Job& job) {
  const Program& program = job.session.program();
  const DeriveOptions options = derive_options(job.arguments, program);
  const bool keep_going = job.arguments.has("--keep-going");
  std::size_t broken = 0;
  const FootprintSet set =
      footprints(job.session, job.arguments.positional()[1], job.arguments, broken);
  const auto started = std::chrono::steady_clock::now();
  const auto writer = writer_of(job, model_comment(program, set, options));
  const std::vector<std::string_view> symbols = symbol_names(program);
  const std::string_view style = program.styles[program.main_style].name;
  std::optional<OutputFile> report_file;  // a folder that is missing is said before the work
  if (const auto path = job.arguments.value("--report")) report_file.emplace(*path);
  Looks looks(program);
  Report report(program);
  Remarks remarks(job.session);
  const Totals totals = [&] {
    Progress progress(set.footprints.size(), job.session.quiet());
    return derive_all(program, job.session.meshes(), set.footprints, options,
                      thread_option(job.arguments), keep_going, [&](Derived& derived) {
                        Building& building = derived.building;
                        remarks.add(building);
                        progress.step();
                        if (derived.error) {
                          job.session.print(*derived.error);
                          return report.add_failure(building.id, *derived.error);
                        }
                        looks.adopt(building);
                        report.add(building);
                        writer->add(
                            {building.id, &building.surface, style, derived.footprint->properties},
                            symbols, looks.all());
                      });
  }();
  if (totals.interrupted) {
    job.session.say("interrupted: nothing was written");
    return 130;
  }
  if (totals.failed > 0 && !keep_going) return exit_input;
  const std::size_t bytes = writer->finish(looks.all());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - started;
  if (report_file) report.write(*report_file, seconds.count());
  job.session.say(summary(report, bytes, job.out) + job.session.style_taken(job.arguments));
  remarks.finish(program);
  if (totals.failed + broken > 0)
    job.session.say(std::to_string(totals.failed + broken) +
                    (totals.failed + broken == 1 ? " footprint was" : " footprints were") +
                    " left out");
  return totals.failed + broken > 0 ? exit_input : exit_done;
}

}  // namespace

int run_derive(const Arguments& arguments) {
  Session session(arguments);
  Job job{session, arguments, output_of(arguments)};
  up_of(arguments);
  refuse_own_input(arguments, job.out);
  return session.guard([&]() -> int {
    if (!session.compile(arguments.positional()[0], compile_options(arguments))) return exit_input;
    return derive(job);
  });
}

}  // namespace mansard
