#include "render/stain.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/random.hpp"

namespace mansard {
namespace {

struct Particle {
  double x, y, vx, vy;
  double stain, water;
  uint64_t draws;  ///< its own random stream
};

struct Texel {
  double stain = 0, water = 0;
};

class Flow {
 public:
  Flow(const StainFlow& flow, uint64_t seed)
      : flow_(flow),
        seed_(seed),
        fastest_(1 / flow.step),
        wall_(static_cast<std::size_t>(flow.width) * static_cast<std::size_t>(flow.height)) {
    for (const StainFlow::Source& source : flow.sources) shares_ += source.share;
  }

  StainField run() {
    for (int i = 0; i < flow_.steps && shares_ > 0; ++i) {
      for (int k = 0; k < flow_.drops; ++k) start();
      for (std::size_t p = 0; p < particles_.size();) {
        if (move(particles_[p])) {
          ++p;
        } else {
          leave(p);
        }
      }
    }
    return result();
  }

 private:
  static double draw(Particle& p) { return unit_interval(scramble(p.draws += 0x9e3779b97f4a7c15)); }

  void start() {
    Particle p{0, 0, 0, 0, flow_.concentration, flow_.mass, mix(seed_, started_++)};
    double chosen = draw(p) * shares_;
    std::size_t i = 0;
    while (i + 1 < flow_.sources.size() && chosen >= flow_.sources[i].share)
      chosen -= flow_.sources[i++].share;
    const StainFlow::Source& source = flow_.sources[i];
    const double aside = draw(p) + draw(p) - 1;  // more in the middle
    p.y = draw(p);                               // else all of them would step on the same rows
    p.x = std::clamp(source.at + source.spread * aside, 0.0, flow_.width - 1e-6);
    particles_.push_back(p);
    field_.stain_brought += p.stain;
    field_.water_brought += p.water;
  }

  /// False once it has left the wall.
  bool move(Particle& p) {
    ++field_.moves;
    Texel& here = wall_[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(flow_.width) +
                        static_cast<std::size_t>(p.x)];
    const double dt = flow_.step, thirst = (flow_.absorption - here.water) / flow_.absorption;
    const double slip = 1 - std::max(0.2, std::min(thirst, 1.0));  // a dry wall holds it
    p.vx += (2 * draw(p) - 1) * flow_.roughness * std::sqrt(p.vx * p.vx + p.vy * p.vy) * dt;
    p.vy += flow_.gravity * dt;
    p.vx = std::clamp(p.vx, -fastest_, fastest_);
    p.vy = std::min(p.vy, fastest_);
    p.x += slip * p.vx * dt;
    p.y += slip * p.vy * dt;
    const double soaked = flow_.absorptivity * thirst * p.water * dt;
    p.water -= soaked;
    here.water += soaked;
    const double left =
        std::clamp((flow_.adhesion * p.stain - flow_.solubility * here.stain * p.water) * dt,
                   -here.stain, p.stain);
    p.stain -= left;
    here.stain += left;
    return p.x >= 0 && p.x < flow_.width && p.y < flow_.height;
  }

  void leave(std::size_t particle) {
    field_.stain_left += particles_[particle].stain;
    field_.water_left += particles_[particle].water;
    particles_[particle] = particles_.back();
    particles_.pop_back();
  }

  StainField result() {
    field_.width = flow_.width;
    field_.height = flow_.height;
    for (const Texel& texel : wall_) {
      field_.stain.push_back(texel.stain);
      field_.water.push_back(texel.water);
    }
    for (const Particle& p : particles_) {
      field_.stain_running += p.stain;
      field_.water_running += p.water;
    }
    return std::move(field_);
  }

  const StainFlow& flow_;
  uint64_t seed_, started_ = 0;
  double fastest_;  ///< texels a second: one a step
  double shares_ = 0;
  std::vector<Texel> wall_;
  std::vector<Particle> particles_;
  StainField field_;
};

}  // namespace

StainField run_down(const StainFlow& flow, uint64_t seed) { return Flow(flow, seed).run(); }

}  // namespace mansard
