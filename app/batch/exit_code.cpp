#include "app/batch/exit_code.hpp"

#include "core/domain/validate.hpp"
#include "core/io/files.hpp"

#include <algorithm>
#include <cstdio>

namespace forefront {

void printFaults(const Diagnostics &faults) {
    for (const Diagnostic &fault : faults) {
        std::fprintf(stderr, "%s\n", toString(fault).c_str());
    }
}

bool hasCode(const Diagnostics &faults, std::string_view code) {
    return std::any_of(faults.begin(), faults.end(), [code](const Diagnostic &d) { return d.code == code; });
}

Diagnostics meshingFaults(const Diagnostics &faults, const Domain &domain, const Input &input, bool asRead) {
    if (hasCode(faults, "cancelled")) {
        return faults;
    }
    Diagnostics own = validate(domain);
    for (Diagnostic &fault : own) {
        if (!asRead) {
            fault.parts.clear(); // the file does not have them
        }
    }
    return own.empty() ? faults : locateFaults(input.path, std::move(own), input.options);
}

} // namespace forefront
