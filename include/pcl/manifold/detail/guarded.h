#pragma once

#include <pcl/manifold/status.h>

#include <exception>
#include <new>
#include <stdexcept>

namespace pcl {
namespace manifold {

/** Runs a computation that answers with a status, and turns what it throws into one: no exception leaves the
 * library. */
template <typename Body>
Status
guarded (const Body& body) noexcept
{
  try {
    return body ();
  } catch (const std::bad_alloc&) {
    return Status::OUT_OF_MEMORY;
  } catch (const std::length_error&) {
    return Status::TOO_MANY_POINTS;
  } catch (...) {
    return Status::INTERNAL_ERROR;
  }
}

} // namespace manifold
} // namespace pcl
