#pragma once

#include <ctime>

namespace forefront {

/// CPU time of the calling thread.
class CpuClock {
  public:
    CpuClock() : start_(now()) {}
    /// Seconds since construction or the last lap.
    double lap() {
        const double end = now();
        const double seconds = end - start_;
        start_ = end;
        return seconds;
    }

  private:
    static double now() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    double start_;
};

} // namespace forefront
