#include "app/batch/standard_output.hpp"

#include "core/engine/platform/file_handle.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

namespace forefront {

StandardOutput::StandardOutput() {
    std::fflush(stdout);
}

bool StandardOutput::write(std::string_view bytes) {
    while (failure_ == 0 && !bytes.empty()) {
        const std::ptrdiff_t done = writeSome(kStandardOutput, bytes);
        if (done >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(done));
        } else if (errno != EINTR) {
            failure_ = errno;
        }
    }
    return failure_ == 0;
}

Status StandardOutput::status() const {
    return failure_ == 0
               ? Status()
               : error("cannot-write", std::string("cannot write to standard output: ") + std::strerror(failure_),
                       "check the free space there, or write to a file");
}

} // namespace forefront
