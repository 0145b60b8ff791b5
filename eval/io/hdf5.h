#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace honka::eval {

/// How a dataset lies on disk. Chunks of some 100 kB stay inside HDF5's cache of 1 MB a dataset.
struct H5Layout {
  std::uint64_t chunk_rows = 1 << 16;
  int deflate = 1;  ///< 0 for none; with shuffle
};

/// The id of one HDF5 object and how to close it.
class H5Handle {
 public:
  using Close = int (*)(std::int64_t);
  H5Handle() = default;
  H5Handle(std::int64_t id, Close close) : id_(id), close_(close) {}
  ~H5Handle() { reset(); }
  H5Handle(H5Handle&& other) noexcept { swap(other); }
  H5Handle& operator=(H5Handle&& other) noexcept {
    swap(other);
    return *this;
  }
  [[nodiscard]] std::int64_t id() const { return id_; }
  /// Closes now; negative when that failed (a late write error).
  int reset();

 private:
  void swap(H5Handle& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
  }
  std::int64_t id_ = -1;
  Close close_ = nullptr;
};

class H5File;

/// One dataset of rows × width numbers held open, to append to or to read slices of.
/// T: u8, u16, u32, u64, i32, i64, float, double. Rows lie one after the other in memory.
template <class T>
class H5Column {
 public:
  H5Column() = default;
  void append(std::span<const T> rows_by_width);
  [[nodiscard]] std::vector<T> read(std::uint64_t first_row, std::uint64_t count) const;
  [[nodiscard]] std::vector<T> read_all() const { return read(0, rows_); }
  [[nodiscard]] std::uint64_t rows() const { return rows_; }

 private:
  friend class H5File;
  H5Handle dataset_;
  std::filesystem::path file_;
  std::string name_;
  std::uint64_t rows_ = 0, width_ = 1;
};

/// The one door to HDF5: a file whose objects are named by their path ("/trials/x_m"). HDF5's own
/// printing is off. One thread at a time. Whatever fails becomes a UserError that names the file:
/// missing, foreign, truncated, an object of another shape, a full disk.
class H5File {
 public:
  /// Makes an empty file, replacing one of that name (give it a StagedFile's temporary name).
  [[nodiscard]] static H5File create(const std::filesystem::path& path);
  /// Opens to read.
  [[nodiscard]] static H5File open(const std::filesystem::path& path);

  void create_group(const std::string& name);
  [[nodiscard]] bool exists(const std::string& name) const;
  /// Names of the members of a group in the order in which they were made.
  [[nodiscard]] std::vector<std::string> members(const std::string& group) const;

  void set_attribute(const std::string& object, const std::string& name, const std::string& value);
  void set_attribute(const std::string& object, const std::string& name, double value);
  void set_attribute(const std::string& object, const std::string& name, std::int64_t value);
  [[nodiscard]] bool has_attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::vector<std::string> attributes(const std::string& object) const;
  [[nodiscard]] std::string string_attribute(const std::string& object,
                                             const std::string& name) const;
  [[nodiscard]] double double_attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::int64_t int_attribute(const std::string& object,
                                           const std::string& name) const;

  template <class T>
  [[nodiscard]] H5Column<T> create_column(const std::string& name, std::uint64_t width = 1,
                                          H5Layout layout = {});
  template <class T>
  [[nodiscard]] H5Column<T> open_column(const std::string& name) const;
  template <class T>
  void write(const std::string& name, std::span<const T> values, std::uint64_t width = 1);
  void write_strings(const std::string& name, const std::vector<std::string>& values);
  [[nodiscard]] std::vector<std::string> read_strings(const std::string& name) const;

  enum class Kind { kDouble, kInteger, kString, kOther };
  [[nodiscard]] Kind kind(const std::string& name) const;

  /// Flushes and closes; a write error that HDF5 held back surfaces here.
  void close();

 private:
  H5Handle file_;
  std::filesystem::path path_;
};

}  // namespace honka::eval
