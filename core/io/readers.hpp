#pragma once

#include "core/io/source.hpp"

namespace forefront {

// The readers proper, from memory; each lives in a file of its own. Every fault carries a place in the source.

Result<Document> readProjectText(const SourceText &source);

} // namespace forefront
