// Messages as they travel: a header that says how many bytes, then the text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mansard::lsp {

/// Reads messages from a file descriptor. What is no header is skipped up to the next one, so that
/// one wrong length does not end the conversation.
class FrameReader {
 public:
  static constexpr std::size_t max_bytes = 64 << 20;  ///< of one message

  explicit FrameReader(int in) : in_(in) {}

  enum class Got { message, broken, nothing, end };
  struct Frame {
    Got got;
    std::string text;  ///< the message, or what was wrong
  };
  /// Waits at most so many milliseconds for the next message; -1: as long as it takes.
  Frame next(int milliseconds);
  /// The text that next() gave was no JSON. When its length was too long, the next message's header
  /// stands in it: reading goes on there.
  void give_back(std::string_view text);

 private:
  std::optional<Frame> take();
  std::optional<Frame> take_body(std::size_t header);
  bool fill(int milliseconds);
  Frame broken(std::size_t skip, std::string why);

  int in_;
  std::string buffer_;
  std::size_t begin_ = 0;    ///< of what was not taken yet
  std::size_t discard_ = 0;  ///< bytes of a message that is too large
  bool ended_ = false, timed_out_ = false, complained_ = false;
};

/// False when the other side does not listen any more.
bool write_frame(int out, std::string_view text);

}  // namespace mansard::lsp
