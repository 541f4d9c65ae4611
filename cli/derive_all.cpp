#include "cli/derive_all.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <thread>

namespace mansard {
namespace {

std::atomic<bool> stop_asked{false};

/// A second Ctrl-C ends the program at once.
void ask_to_stop(int signal) {
  stop_asked = true;
  std::signal(signal, SIG_DFL);
  constexpr char text[] = "\nstopping after the buildings at hand; Ctrl-C again stops at once\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text, sizeof text - 1);
}

/// Buildings on their way, reused so that their memory is.
class Slots {
 public:
  Derived* take() {
    const std::scoped_lock lock(mutex_);
    if (free_.empty()) return &all_.emplace_back();
    Derived* const slot = free_.back();
    free_.pop_back();
    return slot;
  }
  void give_back(Derived* slot) {
    const std::scoped_lock lock(mutex_);
    free_.push_back(slot);
  }

 private:
  std::mutex mutex_;
  std::deque<Derived> all_;
  std::vector<Derived*> free_;
};

void derive_one(Derivation& derivation, const Footprint& footprint, Derived& result) {
  result.error.reset();
  result.footprint = &footprint;
  try {
    derivation.derive(footprint, result.building);
  } catch (Failure& failure) {
    result.error = std::move(failure.diagnostic);
  }
}

}  // namespace

Totals derive_all(const Program& program, MeshSource& meshes,
                  const std::vector<Footprint>& footprints, const DeriveOptions& options,
                  int threads, bool keep_going, const std::function<void(Derived&)>& use) {
  namespace tbb = oneapi::tbb;
  Totals totals;
  std::signal(SIGINT, ask_to_stop);
  const std::size_t count = threads > 0 ? static_cast<std::size_t>(threads)
                                        : std::max(1u, std::thread::hardware_concurrency());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
  tbb::enumerable_thread_specific<Derivation> derivations(
      [&] { return Derivation(program, meshes, options); });
  Slots slots;
  std::size_t next = 0;
  bool failed = false;
  tbb::parallel_pipeline(
      2 * count,
      tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order,
                                          [&](tbb::flow_control& flow) -> std::size_t {
                                            if (next == footprints.size() || failed || stop_asked) {
                                              flow.stop();
                                              return 0;
                                            }
                                            return next++;
                                          }) &
          tbb::make_filter<std::size_t, Derived*>(tbb::filter_mode::parallel,
                                                  [&](std::size_t number) {
                                                    Derived* const slot = slots.take();
                                                    derive_one(derivations.local(),
                                                               footprints[number], *slot);
                                                    return slot;
                                                  }) &
          tbb::make_filter<Derived*, void>(tbb::filter_mode::serial_in_order, [&](Derived* slot) {
            if (!failed) {
              slot->error ? ++totals.failed : ++totals.buildings;
              failed = slot->error && !keep_going;
              use(*slot);
            }
            slots.give_back(slot);
          }));
  totals.interrupted = stop_asked;
  return totals;
}

}  // namespace mansard
