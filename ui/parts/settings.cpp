#include "ui/parts/settings.hpp"

#include "core/files/files.hpp"
#include "core/files/source/source.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

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

bool boolIn(const Json &json, const char *name, bool fallback) {
    const auto found = json.find(name);
    return found != json.end() && found->is_boolean() ? found->get<bool>() : fallback;
}

std::string textIn(const Json &json, const char *name) {
    const auto found = json.find(name);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Returns a number if it is given and above 0, or 0 where that is allowed.
std::optional<double> sizeIn(const Json &json, const char *name, bool zero = false) {
    const auto found = json.find(name);
    const bool number = found != json.end() && found->is_number();
    const double value = number ? found->get<double>() : -1.0;
    return std::isfinite(value) && (value > 0.0 || (zero && value == 0.0)) ? std::optional(value) : std::nullopt;
}

template <class Enum>
Enum choiceIn(const Json &json, const char *name, Enum fallback) {
    return fromWord<Enum>(textIn(json, name)).value_or(fallback);
}

/// Returns the texts of an array, at most `limit` of them.
std::vector<std::string> textsIn(const Json &json, const char *name, std::size_t limit) {
    std::vector<std::string> texts;
    const auto array = json.find(name);
    if (array != json.end() && array->is_array()) {
        for (const Json &entry : *array) {
            if (entry.is_string() && texts.size() < limit) {
                texts.push_back(entry.get<std::string>());
            }
        }
    }
    return texts;
}

/// Calls take(key, value) for each member of an object.
template <class Take>
void forMembers(const Json &json, const char *name, Take take) {
    const auto object = json.find(name);
    if (object != json.end() && object->is_object()) {
        for (const auto &[key, value] : object->items()) {
            take(key, value);
        }
    }
}

/// Reads the members that are objects. Entries of another type are left out.
void readMaps(const Json &json, Settings &settings) {
    forMembers(json, "keys", [&](const std::string &action, const Json &keys) {
        if (keys.is_string()) {
            settings.keys[action] = keys.get<std::string>();
        }
    });
    forMembers(json, "layers", [&](const std::string &layer, const Json &visible) {
        if (visible.is_boolean()) {
            settings.layers[layer] = visible.get<bool>();
        }
    });
    forMembers(json, "folded", [&](const std::string &panel, const Json &folded) {
        if (folded.is_boolean()) {
            settings.folded[panel] = folded.get<bool>();
        }
    });
    forMembers(json, "lessons", [&](const std::string &lesson, const Json &progress) {
        if (!progress.is_object()) {
            return;
        }
        LessonProgress &to = settings.lessons[lesson];
        to.page = static_cast<std::size_t>(numberIn(progress, "page", 0.0, 0.0, 1000.0));
        const auto answered = progress.find("answered");
        if (answered != progress.end() && answered->is_array()) {
            for (const Json &page : *answered) {
                if (page.is_number_unsigned() && page.get<std::uint64_t>() < 1000) {
                    to.answered.insert(page.get<std::size_t>());
                }
            }
        }
    });
    forMembers(json, "views", [&](const std::string &file, const Json &view) {
        const bool numbers = view.is_array() && view.size() == 3 &&
                             std::all_of(view.begin(), view.end(), [](const Json &n) { return n.is_number(); });
        if (numbers && view[2].get<double>() > 0.0) {
            settings.views[file] = {{view[0].get<double>(), view[1].get<double>()}, view[2].get<double>()};
        }
    });
}

} // namespace

namespace {

constexpr std::size_t kMaxSettings = std::size_t{64} << 20; ///< bytes

/// Keeps a copy of settings that cannot be read, since the next change of a setting replaces the file. Returns the
/// warning.
Diagnostics badSettings(const std::filesystem::path &file, const std::string &why) {
    std::filesystem::path copy = file;
    copy += ".old";
    std::error_code failed;
    const bool kept = std::filesystem::is_regular_file(file, failed) &&
                      std::filesystem::copy_file(file, copy, std::filesystem::copy_options::overwrite_existing, failed);
    Diagnostics warning = error("bad-settings", "cannot use the settings: " + why + "; using the default settings",
                                kept ? "repair the copy in " + copy.string() : "");
    warning.front().severity = Severity::Warning;
    warning.front().file = file.string();
    return warning;
}

} // namespace

Settings loadSettings(const std::filesystem::path &file, Diagnostics *faults) {
    Settings settings;
    std::error_code none;
    if (!std::filesystem::exists(file, none)) {
        return settings;
    }
    const Result<std::string> text = readRegularFile(file, kMaxSettings);
    const Json json = text ? Json::parse(*text, nullptr, false) : Json();
    if (!json.is_object()) {
        if (faults != nullptr) {
            *faults = badSettings(file, text ? "is not valid JSON" : text.faults().front().message);
        }
        return settings;
    }
    const auto theme = json.find("theme");
    settings.theme = theme != json.end() && *theme == "light" ? ThemeKind::Light : ThemeKind::Dark;
    settings.scale = numberIn(json, "scale", settings.scale, 0.75, 3.0);
    settings.panelWidth = numberIn(json, "panelWidth", settings.panelWidth, 240.0, 640.0);
    settings.tabsHeight = numberIn(json, "tabsHeight", settings.tabsHeight, kMinTabs, kMaxTabs);
    settings.hints = boolIn(json, "hints", settings.hints);
    settings.rulers = boolIn(json, "rulers", settings.rulers);
    settings.live = boolIn(json, "live", settings.live);
    settings.liveBudget = numberIn(json, "liveBudget", settings.liveBudget, kMinLiveBudget, kMaxLiveBudget);
    settings.panels = boolIn(json, "panels", settings.panels);
    settings.tab = textIn(json, "tab");
    settings.exportFormat = textIn(json, "exportFormat");
    settings.newMethod = choiceIn(json, "newMethod", settings.newMethod);
    settings.newImprove = choiceIn(json, "newImprove", settings.newImprove);
    settings.snapping = {.toDrawing = boolIn(json, "snapToDrawing", true),
                         .toGrid = boolIn(json, "snapToGrid", true),
                         .gridStep = sizeIn(json, "gridStep").value_or(0.0),
                         .reach = numberIn(json, "snapReach", Snapping().reach, kMinSnapReach, kMaxSnapReach),
                         .angleStep = numberIn(json, "angleStep", Snapping().angleStep, kMinAngleStep, kMaxAngleStep)};
    settings.newSize = sizeIn(json, "newSize");
    settings.newGradation = sizeIn(json, "newGradation");
    settings.newPerTurn = sizeIn(json, "newPerTurn", true);
    settings.newAcross = sizeIn(json, "newAcross", true);
    readMaps(json, settings);
    const std::vector<std::string> hidden = textsIn(json, "hiddenTabs", 100);
    settings.hiddenTabs = {hidden.begin(), hidden.end()};
    settings.tabOrder = textsIn(json, "tabOrder", 100);
    settings.recentFiles = textsIn(json, "recentFiles", 12);
    settings.window = placeIn(json);
    return settings;
}

void saveSettings(const std::filesystem::path &file, const Settings &settings) {
    Json json{{"theme", settings.theme == ThemeKind::Light ? "light" : "dark"},
              {"scale", settings.scale},
              {"panelWidth", settings.panelWidth},
              {"tabsHeight", settings.tabsHeight},
              {"hints", settings.hints},
              {"rulers", settings.rulers},
              {"live", settings.live},
              {"liveBudget", settings.liveBudget},
              {"panels", settings.panels},
              {"tab", settings.tab},
              {"hiddenTabs", settings.hiddenTabs},
              {"tabOrder", settings.tabOrder},
              {"exportFormat", settings.exportFormat},
              {"newMethod", wordOf(settings.newMethod)},
              {"newImprove", wordOf(settings.newImprove)},
              {"snapToDrawing", settings.snapping.toDrawing},
              {"snapToGrid", settings.snapping.toGrid},
              {"snapReach", settings.snapping.reach},
              {"gridStep", settings.snapping.gridStep},
              {"angleStep", settings.snapping.angleStep},
              {"keys", settings.keys},
              {"layers", settings.layers},
              {"folded", settings.folded},
              {"views", Json::object()},
              {"recentFiles", settings.recentFiles}};
    for (const auto &[name, number] :
         {std::pair("newSize", settings.newSize), std::pair("newGradation", settings.newGradation),
          std::pair("newPerTurn", settings.newPerTurn), std::pair("newAcross", settings.newAcross)}) {
        if (number) {
            json[name] = *number;
        }
    }
    for (const auto &[name, view] : settings.views) {
        json["views"][name] = {view.centre.x, view.centre.y, view.zoom};
    }
    for (const auto &[name, progress] : settings.lessons) {
        json["lessons"][name] = {{"page", progress.page}, {"answered", progress.answered}};
    }
    if (settings.window) {
        const WindowPlace &place = *settings.window;
        json["window"] = {{"x", place.x},
                          {"y", place.y},
                          {"width", place.width},
                          {"height", place.height},
                          {"maximised", place.maximised}};
    }
    if (!notRegular(file).empty()) {
        return; // writing to a pipe could wait for ever
    }
    std::error_code ignored;
    std::filesystem::create_directories(file.parent_path(), ignored);
    // A lost setting is not worth an error message; a full disk is reported when documents are saved.
    static_cast<void>(writeFileAtomically(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"));
}

} // namespace forefront
