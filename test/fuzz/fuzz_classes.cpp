// Any bytes are a cloud and options: no class may break a promise on them, see ../promises.h.
#include "../promises.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size)
{
  const std::string broken = promises::broken (promises::caseOf (data, size));
  if (!broken.empty ()) {
    std::cerr << broken;
    std::abort ();
  }
  return 0;
}
