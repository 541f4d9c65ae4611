#include "cli/derive_all.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <deque>
#include <exception>

#include "formats/stock.hpp"

namespace mansard {
namespace {

namespace tbb = oneapi::tbb;

std::atomic<bool> stop_asked{false};

/// A second Ctrl-C ends the program at once.
void ask_to_stop(int signal) {
  stop_asked = true;
  std::signal(signal, SIG_DFL);
  constexpr char text[] = "\nstopping after the buildings at hand; Ctrl-C again stops at once\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text, sizeof text - 1);
}

/// A footprint's result on its way.
struct Passenger : Derived {
  std::exception_ptr thrown;  ///< by a step off the main line; told when its turn comes
  bool ends_here = false;     ///< failed, or comes after the failure that ends all
};

/// Some footprints that follow each other: passing one on costs more than the smallest buildings.
struct Batch {
  std::deque<Passenger> all;
  std::size_t first = 0, count = 0;

  template <class Use>
  void for_each(Use use) {
    for (std::size_t i = 0; i < count; ++i) use(all[i]);
  }
};

class Line {
 public:
  Line(const Program& program, MeshSource& meshes, const FootprintSource& footprints,
       const DeriveOptions& options, std::size_t threads, bool keep_going, const Steps& steps)
      : footprints_(footprints),
        threads_(threads),
        keep_going_(keep_going),
        steps_(steps),
        derivations_(
            [&program, &meshes, options] { return Derivation(program, meshes, options); }) {}
  Totals run();

 private:
  Batch* next(tbb::flow_control& flow);
  void derive(Batch& batch);
  void number(Batch& batch);
  void format(Batch& batch);
  void append(Batch& batch);
  std::size_t batch_size() const;

  const FootprintSource& footprints_;
  const std::size_t threads_;
  const bool keep_going_;
  const Steps& steps_;
  tbb::enumerable_thread_specific<Derivation> derivations_;
  Stock<Batch> batches_;
  std::size_t next_ = 0;
  std::atomic<bool> ended_{false};
  std::atomic<std::size_t> derived_{0}, points_{0};
  Totals totals_;
};

Totals Line::run() {
  using enum tbb::filter_mode;
  const auto then = [this](tbb::filter_mode mode, void (Line::*step)(Batch&)) {
    return tbb::make_filter<Batch*, Batch*>(mode, [this, step](Batch* batch) {
      (this->*step)(*batch);
      return batch;
    });
  };
  const auto begin = tbb::make_filter<void, Batch*>(
      serial_in_order, [this](tbb::flow_control& flow) { return next(flow); });
  const auto end = tbb::make_filter<Batch*, void>(serial_in_order, [this](Batch* batch) {
    append(*batch);
    batches_.give_back(batch);
  });
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads_);
  tbb::task_arena arena(static_cast<int>(threads_));
  arena.execute([&] {
    tbb::parallel_pipeline(2 * threads_, begin & then(parallel, &Line::derive) &
                                             then(serial_in_order, &Line::number) &
                                             then(parallel, &Line::format) & end);
  });
  totals_.interrupted = stop_asked;
  return totals_;
}

Batch* Line::next(tbb::flow_control& flow) {
  if (next_ == footprints_.size() || ended_ || stop_asked) {
    flow.stop();
    return nullptr;
  }
  Batch* const batch = batches_.take();
  batch->first = next_;
  batch->count = batch_size();
  while (batch->all.size() < batch->count) batch->all.emplace_back();
  next_ += batch->count;
  return batch;
}

/// So many that they have the points of one middling building, as far as those before tell, and
/// that at the end there is still work for every thread.
std::size_t Line::batch_size() const {
  constexpr std::size_t points = 4000, most = 64;
  const std::size_t known = derived_;
  const std::size_t fit = known == 0 ? 1 : points * known / (points_ + 1);
  const std::size_t fair = (footprints_.size() - next_) / (4 * threads_);
  return std::max<std::size_t>(std::min({fit, fair, most}), 1);
}

void Line::derive(Batch& batch) {
  Derivation& derivation = derivations_.local();
  std::size_t points = 0;
  for (std::size_t i = 0; i < batch.count; ++i) {
    Passenger& p = batch.all[i];
    p.error.reset();
    p.thrown = nullptr;
    p.number = batch.first + i;
    p.footprint = &footprints_.get(p.number, p.room);  // what fails here is no building's fault
    try {
      derivation.derive(*p.footprint, p.building);
      if (steps_.prepare) steps_.prepare(p);
    } catch (Failure& failure) {
      p.error = std::move(failure.diagnostic);
    }
    points += p.building.surface.points.size();
  }
  derived_ += batch.count;
  points_ += points;
}

void Line::number(Batch& batch) {
  batch.for_each([&](Passenger& p) {
    p.ends_here = p.error.has_value() || ended_;
    if (ended_) return;
    p.error ? ++totals_.failed : ++totals_.buildings;
    ended_ = p.error && !keep_going_;
    steps_.number(p);
  });
}

void Line::format(Batch& batch) {
  if (!steps_.format) return;
  batch.for_each([&](Passenger& p) {
    if (p.ends_here) return;
    try {
      steps_.format(p);
    } catch (...) {
      p.thrown = std::current_exception();
    }
  });
}

void Line::append(Batch& batch) {
  if (!steps_.append) return;
  batch.for_each([&](Passenger& p) {
    if (p.thrown) std::rethrow_exception(p.thrown);
    if (!p.ends_here) steps_.append(p);
  });
}

}  // namespace

Totals derive_all(const Program& program, MeshSource& meshes, const FootprintSource& footprints,
                  const DeriveOptions& options, int threads, bool keep_going, const Steps& steps) {
  std::signal(SIGINT, ask_to_stop);
  const int cores = tbb::info::default_concurrency();
  const int count = threads > 0 ? std::min(threads, cores) : cores;
  return Line(program, meshes, footprints, options, static_cast<std::size_t>(count), keep_going,
              steps)
      .run();
}

}  // namespace mansard
