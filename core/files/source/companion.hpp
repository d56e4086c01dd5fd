#pragma once

#include "core/engine/base/result.hpp"
#include "core/files/source/source.hpp"

#include <memory>
#include <string>

namespace forefront {

/// A text file beside the source with another extension, for formats of several files.
struct Companion {
    std::string bytes;
    SourceText source; ///< views `bytes`
};

/// Reads the file beside the source whose extension is `extension`, with the dot. Faults: cannot-read, too-large.
Result<std::unique_ptr<Companion>> readCompanion(const SourceText &source, const char *extension);

} // namespace forefront
