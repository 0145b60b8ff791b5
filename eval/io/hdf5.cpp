#include "eval/io/hdf5.h"

#include <cerrno>
#include <cstring>

#include "algo/types/user_error.h"
#include "eval/io/hdf5_detail.h"
#include "eval/io/safe_file.h"

namespace honka::eval {
namespace {

/// The texts of HDF5's error stack in one string.
std::string error_stack() {
  std::string text;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
        if (error->desc != nullptr) *static_cast<std::string*>(out) += error->desc;
        return 0;
      },
      &text);
  return text;
}

}  // namespace

namespace h5 {

void fail_read(const std::filesystem::path& file, const std::string& what) {
  throw UserError(file.string() + ": " + what +
                  "; it is damaged or was not written by honka, make it again");
}

void fail_write(const std::filesystem::path& file) {
  const std::string stack = error_stack();
  const bool full = stack.find(std::strerror(ENOSPC)) != std::string::npos ||
                    stack.find(std::strerror(EDQUOT)) != std::string::npos;
  const bool denied = stack.find(std::strerror(EACCES)) != std::string::npos;
  throw_write_error(full ? ENOSPC : (denied ? EACCES : EIO), file);
}

H5Handle utf8_type() {
  H5Handle type = handle(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), H5T_VARIABLE);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

}  // namespace h5

using h5::fail_read;
using h5::fail_write;
using h5::handle;
using h5::utf8_type;

namespace {

void write_attribute(hid_t file, const std::string& object, const std::string& name, hid_t type,
                     const void* value, const std::filesystem::path& path) {
  const H5Handle target = handle(H5Oopen(file, object.c_str(), H5P_DEFAULT), H5Oclose);
  const H5Handle space = handle(H5Screate(H5S_SCALAR), H5Sclose);
  const H5Handle attribute = handle(
      H5Acreate2(target.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (H5Awrite(attribute.id(), type, value) < 0) fail_write(path);
}

H5Handle open_attribute(hid_t file, const std::string& object, const std::string& name,
                        H5T_class_t wanted, const std::filesystem::path& path) {
  H5Handle attribute = handle(
      H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const H5Handle type = handle(attribute.id() < 0 ? -1 : H5Aget_type(attribute.id()), H5Tclose);
  if (type.id() < 0 || H5Tget_class(type.id()) != wanted) {
    fail_read(path, "no attribute " + name + " on " + object);
  }
  return attribute;
}

}  // namespace

void h5::silence() {
  static const int kNoExitHandler = H5dont_atexit();
  static_cast<void>(kNoExitHandler);
  thread_local const herr_t kQuiet = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  static_cast<void>(kQuiet);
}

int H5Handle::reset() {
  const std::int64_t id = id_;
  id_ = -1;
  return id >= 0 ? close_(id) : 0;
}

H5File H5File::create(const std::filesystem::path& path) {
  h5::silence();
  H5File file;
  file.path_ = path;
  file.file_ = handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  if (file.file_.id() < 0) fail_write(path);
  return file;
}

H5File H5File::open(const std::filesystem::path& path) {
  h5::silence();
  if (!std::filesystem::exists(path)) {
    throw UserError(path.string() + ": no such file; check the path");
  }
  if (H5Fis_hdf5(path.c_str()) <= 0) {
    throw UserError(path.string() + ": not an HDF5 file; give one that honka wrote");
  }
  H5File file;
  file.path_ = path;
  file.file_ = handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (file.file_.id() < 0) fail_read(path, "an HDF5 file that is truncated");
  return file;
}

void H5File::create_group(const std::string& name) {
  const H5Handle list = handle(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_link_creation_order(list.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  const H5Handle group =
      handle(H5Gcreate2(file_.id(), name.c_str(), H5P_DEFAULT, list.id(), H5P_DEFAULT), H5Gclose);
  if (group.id() < 0) fail_write(path_);
}

bool H5File::exists(const std::string& name) const {
  for (std::size_t slash = name.find('/', 1); slash != std::string::npos;
       slash = name.find('/', slash + 1)) {
    if (H5Lexists(file_.id(), name.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
  }
  return H5Lexists(file_.id(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> H5File::members(const std::string& group) const {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  const H5Handle opened = handle(H5Gopen2(file_.id(), group.c_str(), H5P_DEFAULT), H5Gclose);
  if (opened.id() < 0) fail_read(path_, "no group " + group);
  hsize_t at = 0;
  if (H5Literate(opened.id(), H5_INDEX_CRT_ORDER, H5_ITER_INC, &at, add, &names) < 0) {
    names.clear();
    at = 0;
    H5Literate(opened.id(), H5_INDEX_NAME, H5_ITER_INC, &at, add, &names);
  }
  return names;
}

void H5File::set_attribute(const std::string& object, const std::string& name,
                           const std::string& value) {
  const char* text = value.c_str();
  const H5Handle type = utf8_type();
  write_attribute(file_.id(), object, name, type.id(), &text, path_);
}

void H5File::set_attribute(const std::string& object, const std::string& name, double value) {
  write_attribute(file_.id(), object, name, H5T_NATIVE_DOUBLE, &value, path_);
}

void H5File::set_attribute(const std::string& object, const std::string& name, std::int64_t value) {
  write_attribute(file_.id(), object, name, H5T_NATIVE_INT64, &value, path_);
}

bool H5File::has_attribute(const std::string& object, const std::string& name) const {
  return H5Aexists_by_name(file_.id(), object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> H5File::attributes(const std::string& object) const {
  std::vector<std::string> names;
  hsize_t at = 0;
  H5Aiterate_by_name(
      file_.id(), object.c_str(), H5_INDEX_NAME, H5_ITER_INC, &at,
      [](hid_t, const char* name, const H5A_info_t*, void* out) -> herr_t {
        static_cast<std::vector<std::string>*>(out)->emplace_back(name);
        return 0;
      },
      &names, H5P_DEFAULT);
  return names;
}

std::string H5File::string_attribute(const std::string& object, const std::string& name) const {
  const H5Handle attribute = open_attribute(file_.id(), object, name, H5T_STRING, path_);
  const H5Handle stored = handle(H5Aget_type(attribute.id()), H5Tclose);
  if (H5Tis_variable_str(stored.id()) <= 0) fail_read(path_, "attribute " + name + " of " + object);
  const H5Handle type = utf8_type();
  char* text = nullptr;
  if (H5Aread(attribute.id(), type.id(), &text) < 0) fail_read(path_, "attribute " + name);
  const std::string value = text == nullptr ? "" : text;
  H5free_memory(text);
  return value;
}

double H5File::double_attribute(const std::string& object, const std::string& name) const {
  const H5Handle attribute = open_attribute(file_.id(), object, name, H5T_FLOAT, path_);
  double value = 0.0;
  if (H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, &value) < 0) fail_read(path_, "attribute " + name);
  return value;
}

std::int64_t H5File::int_attribute(const std::string& object, const std::string& name) const {
  const H5Handle attribute = open_attribute(file_.id(), object, name, H5T_INTEGER, path_);
  std::int64_t value = 0;
  if (H5Aread(attribute.id(), H5T_NATIVE_INT64, &value) < 0) fail_read(path_, "attribute " + name);
  return value;
}

H5File::Kind H5File::kind(const std::string& name) const {
  const H5Handle dataset = handle(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  const H5Handle type = handle(dataset.id() < 0 ? -1 : H5Dget_type(dataset.id()), H5Tclose);
  if (type.id() < 0) return Kind::kOther;
  const H5T_class_t type_class = H5Tget_class(type.id());
  if (type_class == H5T_FLOAT) return Kind::kDouble;
  if (type_class == H5T_INTEGER) return Kind::kInteger;
  return type_class == H5T_STRING && H5Tis_variable_str(type.id()) > 0 ? Kind::kString
                                                                       : Kind::kOther;
}

void H5File::close() {
  const bool flushed = H5Fflush(file_.id(), H5F_SCOPE_LOCAL) >= 0;
  if (!flushed) fail_write(path_);
  if (file_.reset() < 0) fail_write(path_);
}

}  // namespace honka::eval
