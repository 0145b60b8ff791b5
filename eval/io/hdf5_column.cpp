#include <algorithm>
#include <array>

#include "eval/io/hdf5_detail.h"

namespace honka::eval {
using h5::fail_read;
using h5::fail_write;
using h5::handle;
namespace {

template <class T>
hid_t memory_type();
template <>
hid_t memory_type<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}
template <>
hid_t memory_type<std::uint16_t>() {
  return H5T_NATIVE_UINT16;
}
template <>
hid_t memory_type<std::uint32_t>() {
  return H5T_NATIVE_UINT32;
}
template <>
hid_t memory_type<std::uint64_t>() {
  return H5T_NATIVE_UINT64;
}
template <>
hid_t memory_type<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
hid_t memory_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
hid_t memory_type<float>() {
  return H5T_NATIVE_FLOAT;
}
template <>
hid_t memory_type<double>() {
  return H5T_NATIVE_DOUBLE;
}

/// Chunked and extendable, deflated with shuffle where asked.
H5Handle create_dataset(hid_t file, const std::string& name, hid_t type, std::uint64_t rows,
                        std::uint64_t width, H5Layout layout) {
  const int rank = width == 1 ? 1 : 2;
  const std::array<hsize_t, 2> size = {rows, width};
  const std::array<hsize_t, 2> limit = {H5S_UNLIMITED, width};
  const std::array<hsize_t, 2> chunk = {layout.chunk_rows, width};
  const H5Handle space = handle(H5Screate_simple(rank, size.data(), limit.data()), H5Sclose);
  const H5Handle list = handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_chunk(list.id(), rank, chunk.data());
  if (layout.deflate > 0) {
    H5Pset_shuffle(list.id());
    H5Pset_deflate(list.id(), static_cast<unsigned>(layout.deflate));
  }
  return handle(
      H5Dcreate2(file, name.c_str(), type, space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
      H5Dclose);
}

}  // namespace

template <class T>
H5Column<T> H5File::create_column(const std::string& name, std::uint64_t width, H5Layout layout) {
  H5Column<T> column;
  column.dataset_ = create_dataset(file_.id(), name, memory_type<T>(), 0, width, layout);
  column.file_ = path_;
  column.name_ = name;
  column.width_ = width;
  if (column.dataset_.id() < 0) fail_write(path_);
  return column;
}

template <class T>
H5Column<T> H5File::open_column(const std::string& name) const {
  if (!exists(name)) fail_read(path_, "no dataset " + name);
  H5Column<T> column;
  column.dataset_ = handle(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  column.file_ = path_;
  column.name_ = name;
  const H5Handle space =
      handle(column.dataset_.id() < 0 ? -1 : H5Dget_space(column.dataset_.id()), H5Sclose);
  std::array<hsize_t, 2> size = {0, 1};
  const int rank = space.id() < 0 ? -1 : H5Sget_simple_extent_ndims(space.id());
  if (rank < 1 || rank > 2) fail_read(path_, "dataset " + name + " has another shape");
  H5Sget_simple_extent_dims(space.id(), size.data(), nullptr);
  const H5Handle type = handle(H5Dget_type(column.dataset_.id()), H5Tclose);
  if (H5Tequal(type.id(), memory_type<T>()) <= 0) {
    fail_read(path_, "dataset " + name + " has another type");
  }
  column.rows_ = size[0];
  column.width_ = size[1];
  return column;
}

template <class T>
void H5Column<T>::append(std::span<const T> values) {
  if (values.empty()) return;
  h5::silence();
  const std::array<hsize_t, 2> start = {rows_, 0};
  const std::array<hsize_t, 2> count = {values.size() / width_, width_};
  const std::array<hsize_t, 2> size = {rows_ + count[0], width_};
  const int rank = width_ == 1 ? 1 : 2;
  if (H5Dset_extent(dataset_.id(), size.data()) < 0) fail_write(file_);
  const H5Handle memory = handle(H5Screate_simple(rank, count.data(), nullptr), H5Sclose);
  const H5Handle space = handle(H5Dget_space(dataset_.id()), H5Sclose);
  H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  if (H5Dwrite(dataset_.id(), memory_type<T>(), memory.id(), space.id(), H5P_DEFAULT,
               values.data()) < 0) {
    fail_write(file_);
  }
  rows_ = size[0];
}

template <class T>
std::vector<T> H5Column<T>::read(std::uint64_t first_row, std::uint64_t rows) const {
  if (first_row > rows_ || rows > rows_ - first_row) fail_read(file_, name_ + " is too short");
  std::vector<T> values(rows * width_);
  if (values.empty()) return values;
  const std::array<hsize_t, 2> start = {first_row, 0};
  const std::array<hsize_t, 2> count = {rows, width_};
  const int rank = width_ == 1 ? 1 : 2;
  const H5Handle memory = handle(H5Screate_simple(rank, count.data(), nullptr), H5Sclose);
  const H5Handle space = handle(H5Dget_space(dataset_.id()), H5Sclose);
  H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  if (H5Dread(dataset_.id(), memory_type<T>(), memory.id(), space.id(), H5P_DEFAULT,
              values.data()) < 0) {
    fail_read(file_, name_ + " cannot be read");
  }
  return values;
}

template <class T>
void H5File::write(const std::string& name, std::span<const T> values, std::uint64_t width) {
  const std::uint64_t rows = values.size() / width;
  const std::uint64_t chunk = std::min<std::uint64_t>(std::max<std::uint64_t>(rows, 1), 1 << 14);
  create_column<T>(name, width, {chunk, 1}).append(values);
}

void H5File::write_strings(const std::string& name, const std::vector<std::string>& values) {
  std::vector<const char*> texts;
  for (const std::string& value : values) texts.push_back(value.c_str());
  const H5Handle type = h5::utf8_type();
  const std::uint64_t chunk =
      std::min<std::uint64_t>(std::max<std::size_t>(values.size(), 1), 4096);
  const H5Handle dataset =
      create_dataset(file_.id(), name, type.id(), values.size(), 1, {chunk, 0});
  if (dataset.id() < 0 || (!texts.empty() && H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL,
                                                      H5P_DEFAULT, texts.data()) < 0)) {
    fail_write(path_);
  }
}

std::vector<std::string> H5File::read_strings(const std::string& name) const {
  if (!exists(name) || kind(name) != Kind::kString) fail_read(path_, "no texts " + name);
  const H5Handle dataset = handle(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  const H5Handle space = handle(H5Dget_space(dataset.id()), H5Sclose);
  const H5Handle type = h5::utf8_type();
  std::vector<char*> texts(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
  std::vector<std::string> values;
  if (texts.empty()) return values;
  if (H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()) < 0) {
    fail_read(path_, name + " cannot be read");
  }
  for (const char* text : texts) values.emplace_back(text == nullptr ? "" : text);
  H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, texts.data());
  return values;
}

#define HONKA_H5_INSTANTIATE(T)                                                            \
  template class H5Column<T>;                                                              \
  template H5Column<T> H5File::create_column(const std::string&, std::uint64_t, H5Layout); \
  template H5Column<T> H5File::open_column(const std::string&) const;                      \
  template void H5File::write(const std::string&, std::span<const T>, std::uint64_t);
HONKA_H5_INSTANTIATE(std::uint8_t)
HONKA_H5_INSTANTIATE(std::uint16_t)
HONKA_H5_INSTANTIATE(std::uint32_t)
HONKA_H5_INSTANTIATE(std::uint64_t)
HONKA_H5_INSTANTIATE(std::int32_t)
HONKA_H5_INSTANTIATE(std::int64_t)
HONKA_H5_INSTANTIATE(float)
HONKA_H5_INSTANTIATE(double)
#undef HONKA_H5_INSTANTIATE

}  // namespace honka::eval
