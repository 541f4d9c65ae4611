// mansard stains
#include "render/stain_picture.hpp"

#include "cli/picture.hpp"
#include "cli/session.hpp"
#include "formats/output_file.hpp"

namespace mansard {

int run_stains(const Arguments& arguments) {
  const std::string out = picture_output(arguments);
  const auto seed = arguments.number("--seed", 0, 0, 1'000'000'000'000'000);
  const std::vector<uint8_t> atlas =
      make_stain_atlas(static_cast<uint64_t>(seed), thread_option(arguments));
  OutputFile file(out);
  file.put(encode_stain_atlas(atlas));
  file.commit();
  Session(arguments).say("stains: " + out);
  return exit_done;
}

}  // namespace mansard
