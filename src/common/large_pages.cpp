#include "common/large_pages.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace pcl {
namespace manifold {

namespace {

// Arrays of fewer bytes are not worth a call of the kernel of their own.
constexpr std::size_t LARGE = std::size_t (4) << 20;
constexpr std::uintptr_t SMALL_PAGE = 4096;

} // namespace

void
adviseLargePages (void* begin, std::size_t bytes) noexcept
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  if (bytes < LARGE)
    return;
  const std::uintptr_t first =
    (reinterpret_cast<std::uintptr_t> (begin) + SMALL_PAGE - 1) & ~(SMALL_PAGE - 1);
  const std::uintptr_t last = (reinterpret_cast<std::uintptr_t> (begin) + bytes) & ~(SMALL_PAGE - 1);
  // An advice: where it is refused, small pages do as well. On a system whose pages are larger than these
  // the call may be refused for that.
  (void)madvise (reinterpret_cast<void*> (first), last - first, MADV_HUGEPAGE);
#else
  (void)begin;
  (void)bytes;
#endif
}

} // namespace manifold
} // namespace pcl
