#pragma once

#include <cstdint>
#include <ctime>

namespace forefront {

/// Measures CPU time of the calling thread, or of all threads of the program.
class CpuClock {
  public:
    enum class Of : std::uint8_t { Thread, Program };

    explicit CpuClock(Of of = Of::Thread)
        : id_(of == Of::Thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID), start_(now()) {}
    /// Returns the seconds since construction or the last lap.
    double lap() {
        const double end = now();
        const double seconds = end - start_;
        start_ = end;
        return seconds;
    }

  private:
    double now() const {
        timespec time{};
        clock_gettime(id_, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    clockid_t id_;
    double start_;
};

} // namespace forefront
