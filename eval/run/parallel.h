#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <vector>

namespace honka::eval {

/// Calls work(0) … work(count − 1) on so many threads, each once and in no order. Once one throws,
/// later ones are left out; what comes out in the end is the exception of the least number, the
/// same for any number of threads.
template <class Work>
void for_each_index(std::size_t count, int threads, const Work& work) {
  std::vector<std::exception_ptr> failures(count);
  std::atomic<std::size_t> first_failure = count;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t i = 0; i < count; ++i) {
    if (i > first_failure) continue;
    try {
      work(i);
    } catch (...) {
      failures[i] = std::current_exception();
      std::size_t first = first_failure;
      while (i < first && !first_failure.compare_exchange_weak(first, i)) {
      }
    }
  }
  if (first_failure < count) std::rethrow_exception(failures[first_failure]);
}

}  // namespace honka::eval
