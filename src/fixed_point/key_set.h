#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** A set of a few numbers that is filled and emptied very often: emptying it costs no more than what is in
 * it, and its memory is kept. */
class KeySet
{
public:
  KeySet () : slots_ (INITIAL_SLOTS, EMPTY) {}

  /** \param[in] key any number but the largest one
   * \return whether it was not there before */
  bool insert (std::uint64_t key)
  {
    std::size_t slot = slotOf (key);
    if (slots_[slot] == key)
      return false;
    if (2 * (keys_.size () + 1) > slots_.size ()) {
      grow ();
      slot = slotOf (key);
    }
    slots_[slot] = key;
    keys_.push_back (key);
    return true;
  }

  void clear ()
  {
    // From the last one on: no key is then looked for beyond one that is gone already.
    for (; !keys_.empty (); keys_.pop_back ())
      slots_[slotOf (keys_.back ())] = EMPTY;
  }

private:
  static constexpr std::size_t INITIAL_SLOTS = 64;
  static constexpr std::uint64_t EMPTY = UINT64_MAX;

  /** Where a key is, or where it would be put. */
  std::size_t slotOf (std::uint64_t key) const
  {
    const std::size_t mask = slots_.size () - 1;
    std::size_t slot = (key * 0x9e3779b97f4a7c15u >> 32) & mask;
    while (slots_[slot] != key && slots_[slot] != EMPTY)
      slot = (slot + 1) & mask;
    return slot;
  }

  void grow ()
  {
    slots_.assign (2 * slots_.size (), EMPTY);
    for (const std::uint64_t key : keys_)
      slots_[slotOf (key)] = key;
  }

  std::vector<std::uint64_t> slots_; // a power of two of them, at most half of them in use
  std::vector<std::uint64_t> keys_;
};

} // namespace manifold
} // namespace pcl
