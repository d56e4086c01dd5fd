#include "ui/parts/settings.hpp"

#include "core/files/json/json.hpp"
#include "core/files/json/json_writer.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/atomic_file.hpp"
#include "core/teaching/lesson/random_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace forefront {

namespace {

double numberIn(const JsonValue &json, const char *name, double fallback, double minimum, double maximum) {
    const auto found = json.find(name);
    const auto number = found ? found->number() : std::nullopt;
    return number ? std::clamp(*number, minimum, maximum) : fallback;
}

bool boolIn(const JsonValue &json, const char *name, bool fallback) {
    const auto found = json.find(name);
    const bool flag = found && (found->is(JsonKind::True) || found->is(JsonKind::False));
    return flag ? found->is(JsonKind::True) : fallback;
}

/// Returns the saved position of the window; empty if it is missing or invalid.
std::optional<WindowPlace> placeIn(const JsonValue &json) {
    const auto found = json.find("window");
    if (!found) {
        return std::nullopt;
    }
    const auto whole = [&](const char *name, double minimum) {
        return static_cast<int>(numberIn(*found, name, 0.0, minimum, 100000.0));
    };
    const WindowPlace place{.x = whole("x", -100000.0),
                            .y = whole("y", -100000.0),
                            .width = whole("width", 0.0),
                            .height = whole("height", 0.0),
                            .maximised = boolIn(*found, "maximised", false)};
    return place.width > 0 && place.height > 0 ? std::optional(place) : std::nullopt;
}

std::string textIn(const JsonValue &json, const char *name) {
    const auto found = json.find(name);
    return found ? found->string() : std::string();
}

/// Returns a number if it is given and above 0, or 0 where that is allowed.
std::optional<double> sizeIn(const JsonValue &json, const char *name, bool zero = false) {
    const auto found = json.find(name);
    const double value = found ? found->number().value_or(-1.0) : -1.0;
    return std::isfinite(value) && (value > 0.0 || (zero && value == 0.0)) ? std::optional(value) : std::nullopt;
}

template <class Enum>
Enum choiceIn(const JsonValue &json, const char *name, Enum fallback) {
    return fromWord<Enum>(textIn(json, name)).value_or(fallback);
}

/// Returns the texts of an array, at most `limit` of them.
std::vector<std::string> textsIn(const JsonValue &json, const char *name, std::size_t limit) {
    std::vector<std::string> texts;
    const auto array = json.find(name);
    if (array && array->is(JsonKind::Array)) {
        for (const JsonValue entry : *array) {
            if (entry.is(JsonKind::String) && texts.size() < limit) {
                texts.push_back(entry.string());
            }
        }
    }
    return texts;
}

/// Calls take(key, value) for each member of an object.
template <class Take>
void forMembers(const JsonValue &json, const char *name, Take take) {
    const auto object = json.find(name);
    if (object && object->is(JsonKind::Object)) {
        for (auto member = object->begin(); !(member == object->end()); ++member) {
            take(member.key(), *member);
        }
    }
}

/// Reads how far a lesson has been done.
LessonProgress lessonIn(const JsonValue &json) {
    constexpr std::int64_t kMaxPages = 1000;
    LessonProgress progress;
    progress.page = static_cast<std::size_t>(numberIn(json, "page", 0.0, 0.0, static_cast<double>(kMaxPages)));
    progress.seed = static_cast<std::uint64_t>(numberIn(json, "seed", 1.0, 1.0, static_cast<double>(kMaxLessonSeed)));
    return progress;
}

/// Reads the members of an object that are true or false.
void readFlags(const JsonValue &json, const char *name, std::map<std::string, bool> &to) {
    forMembers(json, name, [&to](const std::string &key, const JsonValue &value) {
        if (value.is(JsonKind::True) || value.is(JsonKind::False)) {
            to[key] = value.is(JsonKind::True);
        }
    });
}

/// Reads the workspace and what the user changed in each.
void readWorkspaces(const JsonValue &json, Settings &settings) {
    settings.workspace = workspaceOf(textIn(json, "workspace")).value_or(settings.workspace);
    const std::vector<std::string> pinned = textsIn(json, "pinned", 100);
    settings.pinned = {pinned.begin(), pinned.end()};
    forMembers(json, "workspaces", [&settings](const std::string &word, const JsonValue &value) {
        const std::optional<WorkspaceKind> kind = workspaceOf(word);
        if (kind && value.is(JsonKind::Object)) {
            WorkspaceChanges &changes = settings.workspaces[static_cast<std::size_t>(*kind)];
            readFlags(value, "panels", changes.panels);
            readFlags(value, "folded", changes.folded);
            readFlags(value, "layers", changes.layers);
            changes.order = textsIn(value, "order", 100);
        }
    });
}

/// Reads the members that are objects. Entries of another type are left out.
void readMaps(const JsonValue &json, Settings &settings) {
    forMembers(json, "keys", [&](const std::string &action, const JsonValue &keys) {
        if (keys.is(JsonKind::String)) {
            settings.keys[action] = keys.string();
        }
    });
    forMembers(json, "folders", [&](const std::string &dialog, const JsonValue &folder) {
        if (folder.is(JsonKind::String)) {
            settings.folders[dialog] = folder.string();
        }
    });
    forMembers(json, "toolUses", [&](const std::string &tool, const JsonValue &uses) {
        if (const auto count = uses.integer(); count && *count > 0) {
            settings.toolUses[tool] = static_cast<int>(std::min<std::int64_t>(*count, 1000));
        }
    });
    forMembers(json, "lessons", [&](const std::string &lesson, const JsonValue &progress) {
        if (progress.is(JsonKind::Object)) {
            settings.lessons[lesson] = lessonIn(progress);
        }
    });
    forMembers(json, "views", [&](const std::string &file, const JsonValue &view) {
        std::vector<double> numbers;
        for (const JsonValue number : view) {
            numbers.push_back(number.number().value_or(std::numeric_limits<double>::quiet_NaN()));
        }
        const bool valid = view.is(JsonKind::Array) && numbers.size() == 3 && isFinite({numbers[0], numbers[1]});
        if (valid && numbers[2] > 0.0) {
            settings.views[file] = {{numbers[0], numbers[1]}, numbers[2]};
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
    SourceText source;
    source.name = file.string();
    source.text = text ? std::string_view(*text) : std::string_view();
    const Result<JsonDocument> parsed = text ? JsonDocument::parse(source) : text.faults();
    if (!parsed || !parsed->root().is(JsonKind::Object)) {
        if (faults != nullptr) {
            *faults = badSettings(file, parsed ? "expected a JSON object" : parsed.faults().front().message);
        }
        return settings;
    }
    const JsonValue json = parsed->root();
    settings.theme = textIn(json, "theme") == "light" ? ThemeKind::Light : ThemeKind::Dark;
    settings.scale = numberIn(json, "scale", settings.scale, 0.75, 3.0);
    if (const auto width = sizeIn(json, "columnWidth")) {
        settings.panelWidth = std::clamp(*width, kMinPanelWidth, kMaxPanelWidth);
    }
    settings.hints = boolIn(json, "hints", settings.hints);
    settings.rulers = boolIn(json, "rulers", settings.rulers);
    settings.reduceMotion = boolIn(json, "reduceMotion", settings.reduceMotion);
    settings.live = boolIn(json, "live", settings.live);
    settings.liveBudget = numberIn(json, "liveBudget", settings.liveBudget, kMinLiveBudget, kMaxLiveBudget);
    settings.panels = boolIn(json, "panels", settings.panels);
    settings.exportFormat = textIn(json, "exportFormat");
    settings.newMethod = choiceIn(json, "newMethod", settings.newMethod);
    settings.newImprove = choiceIn(json, "newImprove", settings.newImprove);
    settings.snapping = {.toDrawing = boolIn(json, "snapToDrawing", true),
                         .toGrid = boolIn(json, "snapToGrid", true),
                         .toGuides = boolIn(json, "snapToGuides", true),
                         .infers = boolIn(json, "inferRelations", true),
                         .addsConstraints = boolIn(json, "addConstraints", false),
                         .gridStep = sizeIn(json, "gridStep").value_or(0.0),
                         .reach = numberIn(json, "snapReach", Snapping().reach, kMinSnapReach, kMaxSnapReach),
                         .angleStep = numberIn(json, "angleStep", Snapping().angleStep, kMinAngleStep, kMaxAngleStep)};
    settings.newSize = sizeIn(json, "newSize");
    settings.newGradation = sizeIn(json, "newGradation");
    settings.newPerTurn = sizeIn(json, "newPerTurn", true);
    settings.newAcross = sizeIn(json, "newAcross", true);
    readMaps(json, settings);
    readWorkspaces(json, settings);
    settings.recentFiles = textsIn(json, "recentFiles", 12);
    settings.recentMeshes = textsIn(json, "recentMeshes", 12);
    settings.reopens = boolIn(json, "reopens", settings.reopens);
    settings.lastFile = textIn(json, "lastFile");
    settings.openFiles = textsIn(json, "openFiles", 100);
    settings.window = placeIn(json);
    return settings;
}

namespace {

template <class Map>
void writeMap(JsonWriter &json, const char *name, const Map &entries) {
    json.key(name).beginObject();
    for (const auto &[key, value] : entries) {
        json.member(key, value);
    }
    json.endObject();
}

void writeWorkspaces(JsonWriter &json, const Settings &settings) {
    json.member("workspace", presetOf(settings.workspace).word);
    json.key("pinned").values(settings.pinned).key("workspaces").beginObject();
    for (const WorkspaceKind kind : kWorkspaceKinds) {
        const WorkspaceChanges &changes = settings.workspaces[static_cast<std::size_t>(kind)];
        if (changes == WorkspaceChanges()) {
            continue;
        }
        json.key(presetOf(kind).word).beginObject();
        writeMap(json, "panels", changes.panels);
        writeMap(json, "folded", changes.folded);
        writeMap(json, "layers", changes.layers);
        json.key("order").values(changes.order).endObject();
    }
    json.endObject();
}

} // namespace

void saveSettings(const std::filesystem::path &file, const Settings &settings) {
    JsonWriter json(JsonWriter::Layout::Indented);
    json.beginObject();
    json.member("theme", settings.theme == ThemeKind::Light ? "light" : "dark").member("scale", settings.scale);
    if (settings.panelWidth) {
        json.member("columnWidth", *settings.panelWidth);
    }
    json.member("hints", settings.hints).member("rulers", settings.rulers);
    json.member("reopens", settings.reopens).member("lastFile", settings.lastFile);
    json.member("reduceMotion", settings.reduceMotion);
    json.member("live", settings.live).member("liveBudget", settings.liveBudget);
    json.member("panels", settings.panels);
    writeWorkspaces(json, settings);
    json.member("exportFormat", settings.exportFormat);
    json.member("newMethod", wordOf(settings.newMethod)).member("newImprove", wordOf(settings.newImprove));
    json.member("snapToDrawing", settings.snapping.toDrawing)
        .member("snapToGrid", settings.snapping.toGrid || settings.snapping.offForPicture);
    json.member("snapToGuides", settings.snapping.toGuides)
        .member("inferRelations", settings.snapping.infers)
        .member("addConstraints", settings.snapping.addsConstraints);
    json.member("snapReach", settings.snapping.reach).member("gridStep", settings.snapping.gridStep);
    json.member("angleStep", settings.snapping.angleStep);
    for (const auto &[name, number] :
         {std::pair("newSize", settings.newSize), std::pair("newGradation", settings.newGradation),
          std::pair("newPerTurn", settings.newPerTurn), std::pair("newAcross", settings.newAcross)}) {
        if (number) {
            json.member(name, *number);
        }
    }
    writeMap(json, "keys", settings.keys);
    writeMap(json, "folders", settings.folders);
    writeMap(json, "toolUses", settings.toolUses);
    json.key("views").beginObject();
    for (const auto &[name, view] : settings.views) {
        json.key(name).values(std::array{view.centre.x, view.centre.y, view.zoom});
    }
    json.endObject().key("lessons").beginObject();
    for (const auto &[name, progress] : settings.lessons) {
        json.key(name).beginObject().member("page", progress.page).member("seed", progress.seed).endObject();
    }
    json.endObject().key("recentFiles").values(settings.recentFiles);
    json.key("recentMeshes").values(settings.recentMeshes);
    json.key("openFiles").values(settings.openFiles);
    if (settings.window) {
        const WindowPlace &place = *settings.window;
        json.key("window").beginObject().member("x", place.x).member("y", place.y);
        json.member("width", place.width).member("height", place.height);
        json.member("maximised", place.maximised).endObject();
    }
    json.endObject();
    if (!notRegular(file).empty()) {
        return; // writing to a pipe could wait for ever
    }
    std::error_code ignored;
    std::filesystem::create_directories(file.parent_path(), ignored);
    // A lost setting is not worth an error message; a full disk is reported when documents are saved.
    static_cast<void>(writeFileAtomically(file, json.text()));
}

} // namespace forefront
