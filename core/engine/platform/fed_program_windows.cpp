#ifdef _WIN32

#include "core/engine/platform/fed_program.hpp"

#include <cerrno>

namespace forefront {

struct FedProgram::Process {};

FedProgram::FedProgram() = default;
FedProgram::~FedProgram() = default;

std::unique_ptr<FedProgram> FedProgram::start(std::span<const std::string> /*call*/, int &failure) {
    failure = ENOSYS;
    return nullptr;
}

bool FedProgram::send(std::span<const std::uint8_t> /*bytes*/) {
    return false;
}

int FedProgram::finish() {
    return -1;
}

std::string FedProgram::firstWords() const {
    return {};
}

} // namespace forefront

#endif
