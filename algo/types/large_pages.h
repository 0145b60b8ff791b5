#pragma once

#include <cstddef>
#include <vector>

namespace honka {

/// Asks the system to back memory that is not yet touched by pages of 2 MB. A hint, heard on Linux
/// alone: random accesses to hundreds of megabytes else wait for the translation of addresses.
void advise_large_pages(void* begin, std::size_t bytes);

/// Reserves a list in large pages; to be called while it is empty.
template <class T>
void reserve_in_large_pages(std::vector<T>& list, std::size_t count) {
  list.reserve(count);
  advise_large_pages(list.data(), count * sizeof(T));
}

}  // namespace honka
