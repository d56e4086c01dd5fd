#include "app/batch/extrude_option.hpp"

#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/number_text.hpp"

#include <charconv>
#include <cmath>

namespace forefront {

namespace {

/// Parses H or H:N. Returns nothing for other texts.
std::optional<Extrusion> parseExtrusion(const std::string &text) {
    Extrusion extrusion;
    const char *const end = text.data() + text.size();
    const auto height = std::from_chars(text.data(), end, extrusion.height);
    if (height.ec != std::errc() || !std::isfinite(extrusion.height) || !(extrusion.height > 0.0)) {
        return std::nullopt;
    }
    if (height.ptr == end) {
        return extrusion;
    }
    const auto layers = *height.ptr == ':' ? std::from_chars(height.ptr + 1, end, extrusion.layers) : height;
    const bool valid =
        layers.ec == std::errc() && layers.ptr == end && extrusion.layers >= 1 && extrusion.layers <= kMaxLayers;
    return valid ? std::optional(extrusion) : std::nullopt;
}

std::string formatsWithSolids() {
    std::string list;
    for (const FileFormat &format : allFormats().list()) {
        if (format.holdsSolids) {
            list += (list.empty() ? "" : ", ") + std::string(format.id) + " (" + format.extension + ')';
        }
    }
    return list;
}

} // namespace

void addExtrudeOption(CLI::App &app, MeshForm &form) {
    app.add_option_function<std::string>(
           "--extrude",
           [&form](const std::string &text) {
               form.extrusion = parseExtrusion(text);
               if (!form.extrusion) {
                   throw CLI::ValidationError("--extrude", "expected a height above 0, or HEIGHT:LAYERS with 1 to " +
                                                               std::to_string(kMaxLayers) + " layers, got '" + text +
                                                               "'");
               }
           },
           "make prisms and hexahedra of the elements, H high in N layers (default 1), with boundary parts as faces "
           "and "
           "the new parts back and front; formats: " +
               formatsWithSolids())
        ->type_name("H[:N]");
}

std::string checkExtrude(const MeshForm &form, const std::vector<Output> &outputs, std::optional<ElementOrder> order) {
    if (form.extrusion && outputs.empty()) {
        return "--extrude: no mesh is written; add -o OUT";
    }
    for (const Output &output : outputs) {
        const FileFormat *format = output.format.empty() ? nullptr : allFormats().withId(output.format);
        if (output.format.empty()) {
            for (const FileFormat *named : allFormats().withExtensionOf(output.path)) {
                format = format == nullptr && named->writesMesh ? named : format;
            }
        }
        if (format != nullptr && form.extrusion && !format->holdsSolids) {
            return "--extrude: " + std::string(format->name) + " files hold no prisms and hexahedra; write one of " +
                   formatsWithSolids();
        }
        if (format != nullptr && (form.extrusion || format->solidsOnly) && order == ElementOrder::Second) {
            return std::string(form.extrusion ? "--extrude" : "-o " + output.path.string()) +
                   ": elements of second order cannot be extruded; leave out --order 2";
        }
    }
    return {};
}

} // namespace forefront
