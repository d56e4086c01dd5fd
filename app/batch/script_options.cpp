#include "app/batch/script_options.hpp"

#include "app/batch/elevation_option.hpp"
#include "core/drawing_files/script/script_player.hpp"
#include "core/files/json/json_check.hpp"

#include <optional>
#include <string>

namespace forefront {

Result<DrawingArguments> openOptions(const ScriptCommand &command, const SourceText &source) {
    JsonCheck check(source);
    DrawingArguments options;
    const auto text = [&](const char *member) -> std::optional<std::string> {
        const auto value = command.value.find(member);
        return value ? std::optional(check.string(*value, member)) : std::nullopt;
    };
    if (const auto projection = command.value.find("projection")) {
        const std::string word = check.string(*projection, "\"projection\"");
        const std::string wrong = check.faults().empty() ? setProjection(word, options) : std::string();
        if (!wrong.empty()) {
            check.fault(*projection, "bad-value", "\"projection\": " + wrong);
        }
    }
    options.layer = text("layer");
    options.nameProperty = text("nameProperty");
    options.sizeProperty = text("sizeProperty");
    if (const auto weld = command.value.find("weld")) {
        options.weldTolerance = check.notNegative(*weld, "\"weld\"");
    }
    if (!check.faults().empty()) {
        return check.faults();
    }
    return options;
}

Result<MeshForm> exportForm(const ScriptCommand &command, const SourceText &source) {
    JsonCheck check(source);
    MeshForm form;
    if (const auto open = command.value.find("open"); open && check.expect(*open, JsonKind::Array, "\"open\"")) {
        for (const JsonValue name : *open) {
            form.open.push_back(check.string(name, "the name of a boundary part"));
        }
    }
    if (!check.faults().empty()) {
        return check.faults();
    }
    const Result<std::string> elevation = optionalText(command, "elevation", source);
    if (!elevation) {
        return elevation.faults();
    }
    if (!elevation->empty()) {
        const std::string file = (source.path.parent_path() / *elevation).string();
        form.elevation = isElevationFile(file) ? file : *elevation;
    }
    return form;
}

} // namespace forefront
