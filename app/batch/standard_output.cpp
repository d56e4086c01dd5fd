#include "app/batch/standard_output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <unistd.h>

namespace forefront {

StandardOutput::StandardOutput() {
    std::fflush(stdout);
}

bool StandardOutput::write(std::string_view bytes) {
    while (failure_ == 0 && !bytes.empty()) {
        const ssize_t done = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
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
