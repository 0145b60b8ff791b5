#pragma once

// Shared by the .cpp files behind eval/io/hdf5.h and by nobody else.

#include <hdf5.h>

#include <filesystem>
#include <string>

#include "eval/io/hdf5.h"

namespace honka::eval::h5 {

/// HDF5 neither prints, which it settles thread by thread, nor cleans up at exit, where it would
/// write once more, and crash, on a file that it could not close on a full disk. Comes before the
/// first other call of HDF5 in each thread.
void silence();

/// UserError for a file whose content is not what it should be.
[[noreturn]] void fail_read(const std::filesystem::path& file, const std::string& what);

/// UserError for a failed write, with the system's reason as HDF5 knows it (a full disk).
[[noreturn]] void fail_write(const std::filesystem::path& file);

[[nodiscard]] inline H5Handle handle(hid_t id, herr_t (*close)(hid_t)) { return {id, close}; }

/// Variable-length UTF-8, which h5py reads as str.
[[nodiscard]] H5Handle utf8_type();

}  // namespace honka::eval::h5
