#pragma once

#include <atomic>
#include <cerrno>
#include <cstdlib>

/** A malloc that fails when it is told to: the allocations of operator new and of Eigen, in all libraries and
 * threads. To be included by one source file of a test. */
namespace failing_malloc {

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr bool AVAILABLE = true;
#else
constexpr bool AVAILABLE = false;
#endif

inline std::atomic<bool> armed{false};
inline std::atomic<bool> fails_once{true};
inline std::atomic<long> allocations{0}; ///< since it was armed
inline std::atomic<long> first_failure{0};

/** \brief Whether the allocation that is asked for now fails. */
inline bool
failsNow ()
{
  if (!armed)
    return false;
  const long number = allocations++;
  return fails_once ? number == first_failure : number >= first_failure;
}

/** \brief Runs with the n-th allocation failing, or that and all after it.
 * \return whether there were so many */
template <typename Body>
bool
failDuring (long n, bool once, const Body& body)
{
  allocations = 0;
  first_failure = n;
  fails_once = once;
  struct Armed
  {
    Armed () { armed = true; }
    ~Armed () { armed = false; }
  };
  {
    const Armed until_the_end;
    body ();
  }
  return allocations > n;
}

/** \brief The number of allocations. */
template <typename Body>
long
countDuring (const Body& body)
{
  constexpr long NEVER = -1;
  failDuring (NEVER, true, body);
  return allocations;
}

} // namespace failing_malloc

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C" void* __libc_malloc (std::size_t bytes);
extern "C" void* __libc_memalign (std::size_t alignment, std::size_t bytes);

extern "C" void*
malloc (std::size_t bytes) noexcept
{
  if (!failing_malloc::failsNow ())
    return __libc_malloc (bytes);
  errno = ENOMEM;
  return nullptr;
}

extern "C" void*
aligned_alloc (std::size_t alignment, std::size_t bytes) noexcept
{
  if (!failing_malloc::failsNow ())
    return __libc_memalign (alignment, bytes);
  errno = ENOMEM;
  return nullptr;
}
#endif
