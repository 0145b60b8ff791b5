#include <openssl/evp.h>

#include <bit>
#include <cmath>
#include <memory>

#include "algo/types/check.h"
#include "eval/io/table.h"

namespace honka::eval {
namespace {

/// SHA-256 fed piece by piece.
class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    HONKA_CHECK(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1, "SHA-256");
  }
  void add(std::string_view bytes) {
    HONKA_CHECK(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1, "SHA-256");
  }
  [[nodiscard]] std::string hex() {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned int size = 0;
    HONKA_CHECK(EVP_DigestFinal_ex(context_.get(), digest, &size) == 1, "SHA-256");
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (unsigned int i = 0; i < size; ++i) {
      text += kDigits[digest[i] >> 4];
      text += kDigits[digest[i] & 15];
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_;
};

void put_u64(std::string& bytes, std::uint64_t value) {
  for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>((value >> shift) & 0xff);
}

void put(std::string& bytes, double value) {
  constexpr std::uint64_t kQuietNan = 0x7ff8000000000000;
  if (std::isnan(value)) {
    put_u64(bytes, kQuietNan);
  } else {
    put_u64(bytes, std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value));
  }
}

void put(std::string& bytes, std::int64_t value) {
  put_u64(bytes, static_cast<std::uint64_t>(value));
}

void put(std::string& bytes, const std::string& value) {
  put_u64(bytes, value.size());
  bytes += value;
}

}  // namespace

std::string sha256_hex(std::string_view bytes) {
  Sha256 sha;
  sha.add(bytes);
  return sha.hex();
}

std::string results_digest(const std::vector<const Table*>& tables) {
  Sha256 sha;
  std::string bytes;
  for (const Table* table : tables) {
    for (std::size_t row = 0; row < table->rows(); ++row) {
      bytes.clear();
      for (const Column& column : table->columns()) {
        if (!column.in_digest) continue;
        std::visit([&](const auto& values) { put(bytes, values[row]); }, column.values);
      }
      sha.add(bytes);
    }
  }
  return sha.hex();
}

}  // namespace honka::eval
