#pragma once

#include <cstdint>

namespace forefront {

/// Returns the number of this process, unique among those that run.
long processNumber();

/// Returns the number of the user who runs this process; 0 where users have none.
long userNumber();

/// Returns true if no process of that number runs. False in doubt.
bool processIsGone(long number);

/// Returns the most memory that this process has held so far, in bytes; 0 if the system does not tell.
std::uint64_t peakMemory();

} // namespace forefront
