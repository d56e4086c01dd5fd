#include "ui/parts/settings.hpp"

#include "core/io/files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace forefront {

namespace {

using Json = nlohmann::json;

double numberIn(const Json &json, const char *name, double fallback, double minimum, double maximum) {
    const auto found = json.find(name);
    return found != json.end() && found->is_number() ? std::clamp(found->get<double>(), minimum, maximum) : fallback;
}

/// Returns the saved position of the window; empty if it is missing or invalid.
std::optional<WindowPlace> placeIn(const Json &json) {
    const auto found = json.find("window");
    if (found == json.end() || !found->is_object()) {
        return std::nullopt;
    }
    const auto whole = [&](const char *name, double minimum) {
        return static_cast<int>(numberIn(*found, name, 0.0, minimum, 100000.0));
    };
    const auto maximised = found->find("maximised");
    const WindowPlace place{.x = whole("x", -100000.0),
                            .y = whole("y", -100000.0),
                            .width = whole("width", 0.0),
                            .height = whole("height", 0.0),
                            .maximised = maximised != found->end() && *maximised == true};
    return place.width > 0 && place.height > 0 ? std::optional(place) : std::nullopt;
}

} // namespace

Settings loadSettings(const std::filesystem::path &file, Diagnostics *faults) {
    Settings settings;
    std::ifstream stream(file);
    const bool there = stream.good();
    const Json json = there ? Json::parse(stream, nullptr, false) : Json();
    if (!json.is_object()) {
        if (there && faults != nullptr) {
            *faults = error("bad-settings", file.string() + " is not valid JSON; using the default settings");
            faults->front().severity = Severity::Warning;
        }
        return settings;
    }
    const auto theme = json.find("theme");
    settings.theme = theme != json.end() && *theme == "light" ? ThemeKind::Light : ThemeKind::Dark;
    settings.scale = numberIn(json, "scale", settings.scale, 0.75, 3.0);
    settings.panelWidth = numberIn(json, "panelWidth", settings.panelWidth, 240.0, 640.0);
    settings.tabsHeight = numberIn(json, "tabsHeight", settings.tabsHeight, 90.0, 900.0);
    const auto hints = json.find("hints");
    settings.hints = hints == json.end() || *hints != false;
    const auto live = json.find("live");
    settings.live = live == json.end() || *live != false;
    settings.liveBudget = numberIn(json, "liveBudget", settings.liveBudget, kMinLiveBudget, kMaxLiveBudget);
    settings.window = placeIn(json);
    const auto recent = json.find("recentFiles");
    if (recent != json.end() && recent->is_array()) {
        for (const Json &entry : *recent) {
            if (entry.is_string() && settings.recentFiles.size() < 12) {
                settings.recentFiles.push_back(entry.get<std::string>());
            }
        }
    }
    return settings;
}

void saveSettings(const std::filesystem::path &file, const Settings &settings) {
    Json json{{"theme", settings.theme == ThemeKind::Light ? "light" : "dark"},
              {"scale", settings.scale},
              {"panelWidth", settings.panelWidth},
              {"tabsHeight", settings.tabsHeight},
              {"hints", settings.hints},
              {"live", settings.live},
              {"liveBudget", settings.liveBudget},
              {"recentFiles", settings.recentFiles}};
    if (settings.window) {
        const WindowPlace &place = *settings.window;
        json["window"] = {{"x", place.x},
                          {"y", place.y},
                          {"width", place.width},
                          {"height", place.height},
                          {"maximised", place.maximised}};
    }
    std::error_code ignored;
    std::filesystem::create_directories(file.parent_path(), ignored);
    // A lost setting is not worth an error message; a full disk is reported when documents are saved.
    static_cast<void>(writeFileAtomically(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"));
}

} // namespace forefront
