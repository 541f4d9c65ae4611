// How rain that runs down a wall carries dirt along: the thesis's Algorithm 3.9, after Bosch et al.
// 2011 (Dorsey et al. 1996). Particles of water start at a sill, are drawn into the wall, leave
// stain there and wash it off again.
#pragma once

#include <cstdint>
#include <vector>

namespace mansard {

/// Lengths in texels, times in seconds, y down the wall.
struct StainFlow {
  /// Where water comes from, at the upper edge.
  struct Source {
    double at = 0, spread = 0;  ///< drops start within at - spread and at + spread
    double share = 1;           ///< of the drops, beside the other sources
  };

  int width = 128, height = 256;  ///< 1 to 4096
  std::vector<Source> sources;    ///< none: nothing flows
  double concentration = 1;       ///< of stain in a new particle, S(0)
  double mass = 1;                ///< of water in a new particle, m0
  double adhesion = 0.05;         ///< share of its stain that a particle leaves in a second, k_S
  double solubility = 0.01;       ///< share of a texel's stain that it takes along, k_D
  double roughness = 0.5;         ///< how far the wall turns it aside, r
  double absorption = 1;          ///< most water that a texel holds, a
  double absorptivity = 0.5;      ///< how fast a dry texel takes water, k_a
  double gravity = 9.81;
  double step = 0.1;
  int steps = 3000;
  int drops = 4;  ///< new particles a step
};

/// What came of it. Nothing is lost: what was brought is in the wall, in particles that still run,
/// or has left by the lower edge or a side.
struct StainField {
  int width = 0, height = 0;
  std::vector<double> stain;  ///< in each texel, rows from the top
  std::vector<double> water;  ///< likewise
  double stain_running = 0, water_running = 0;
  double stain_left = 0, water_left = 0;
  double stain_brought = 0, water_brought = 0;
  std::size_t moves = 0;  ///< steps of single particles
};

/// A function of its arguments alone. No particle moves further down than one texel in a step, so
/// that none skips a row.
StainField run_down(const StainFlow& flow, uint64_t seed);

}  // namespace mansard
