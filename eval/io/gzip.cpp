#include "eval/io/gzip.h"

#include <zlib.h>

#include <array>
#include <memory>

#include "algo/types/check.h"
#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"

namespace honka::eval {
namespace {

/// Text beyond this is a mistake or an attack, no list of stems.
constexpr std::size_t kMostBytes = std::size_t{4} << 30U;

bool is_gzipped(const std::string& bytes) {
  return bytes.size() > 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b';
}

/// zlib's state, for as long as it is needed.
class Inflater {
 public:
  Inflater() {
    constexpr int kGzipWindow = 15 + 16;
    HONKA_CHECK(inflateInit2(&stream_, kGzipWindow) == Z_OK, "zlib must have memory");
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  z_stream& stream() { return stream_; }

 private:
  z_stream stream_{};
};

/// Unpacks all members of a gzip file into `text`; why it could not, or nothing.
std::string unpack(const std::string& bytes, std::string& text) {
  Inflater inflater;
  z_stream& stream = inflater.stream();
  std::string packed = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  std::array<char, 1U << 16U> part{};
  for (;;) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    const int status = inflate(&stream, Z_NO_FLUSH);
    if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR) return "is damaged";
    const std::size_t fresh = part.size() - stream.avail_out;
    text.append(part.data(), fresh);
    if (text.size() > kMostBytes) return "unpacks to more than 4 GiB";
    if (status == Z_STREAM_END) {
      if (stream.avail_in == 0) return {};
      if (inflateReset(&stream) != Z_OK) return "is damaged";
    } else if (fresh == 0 && stream.avail_in == 0) {
      return "ends too early";
    }
  }
}

}  // namespace

std::string read_text_or_gzip(const std::filesystem::path& path) {
  std::string bytes = read_text_file(path);
  if (!is_gzipped(bytes)) return bytes;
  std::string text;
  const std::string problem =
      bytes.size() > kMostBytes - 1 ? "is beyond 4 GiB" : unpack(bytes, text);
  if (!problem.empty()) {
    throw UserError(path.string() + ": the gzip file " + problem + "; make or fetch it again");
  }
  return text;
}

}  // namespace honka::eval
