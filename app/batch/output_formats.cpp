#include "app/batch/output_formats.hpp"

#include "core/drawing_files/drawing_formats.hpp"

#include <algorithm>

namespace forefront {

const FileFormat *formatOf(const Output &output) {
    if (!output.format.empty()) {
        return allFormats().withId(output.format);
    }
    for (const FileFormat *format : allFormats().withExtensionOf(output.path)) {
        if (format->writesMesh) {
            return format;
        }
    }
    return nullptr;
}

bool anyHas(const std::vector<Output> &outputs, FormatTrait trait) {
    return std::any_of(outputs.begin(), outputs.end(), [trait](const Output &output) {
        const FileFormat *const format = formatOf(output);
        return format != nullptr && format->*trait;
    });
}

std::string idsOf(FormatTrait trait) {
    std::string list;
    for (const FileFormat &format : allFormats().list()) {
        if (format.*trait) {
            list += (list.empty() ? "" : ", ") + std::string(format.id);
        }
    }
    return list;
}

} // namespace forefront
