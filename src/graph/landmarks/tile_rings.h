#pragma once

#include "graph/landmarks/contact_rows.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Per tile whether the tiles around it may be no disk: those that touch it, or those that touch these, do
 * not hang together by contacts, or there are none. Parallel in the current arena. */
std::vector<std::uint8_t> findDoubtfulTiles (const ContactRows& rows);

} // namespace manifold
} // namespace pcl
