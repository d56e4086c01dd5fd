#include "ui/editor/state_file.hpp"

#include "core/engine/base/hash.hpp"
#include "core/files/source/source.hpp"
#include "ui/editor/editor.hpp"
#include "ui/parts/shell.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace forefront {

namespace {

const char *stateName(RunState state) {
    switch (state) {
    case RunState::Empty:
        return "empty";
    case RunState::Preparing:
        return "preparing";
    case RunState::Running:
        return "running";
    case RunState::Paused:
        return "paused";
    case RunState::Improving:
        return "improving";
    case RunState::Finished:
        return "finished";
    case RunState::Cancelled:
        return "cancelled";
    case RunState::Failed:
        return "failed";
    }
    return "";
}

} // namespace

void writeStateFile(const std::filesystem::path &file, Editor &editor) {
    using Json = nlohmann::json;
    Shell &c = editor.context();
    const SessionSnapshot &run = c.run.now();
    Json widgets = Json::object();
    for (const auto &[name, widget] : c.widgets.all()) {
        widgets[name] = {std::lround(widget.rect.x), std::lround(widget.rect.y), std::lround(widget.rect.width),
                         std::lround(widget.rect.height), widget.enabled ? 1 : 0};
    }
    const Camera &camera = c.view.camera;
    const Json json{
        {"frame", editor.frames()},
        {"settled", editor.settled()},
        {"tool", c.tools.current().id()},
        {"dialog", c.dialogs.top() != nullptr ? c.dialogs.top()->id() : ""},
        {"revision", c.document.revision()},
        {"shapes", c.document.current()->shapes.size()},
        {"paintedTiles", c.document.current()->spacing.paint.tiles.size()},
        {"dirty", c.document.dirty()},
        {"outOfDate", c.run.outOfDate()},
        {"camera", {camera.centre.x, camera.centre.y, camera.zoom}},
        {"run",
         {{"number", run.run},
          {"state", stateName(run.state)},
          {"advance", run.advance},
          {"known", run.known},
          {"complete", run.complete},
          {"elements", run.quality.elements},
          {"stateHash", toHex(run.stateHash)},
          {"meshHash", toHex(run.meshHash)}}},
        {"messages", c.log.entries().size()},
        {"lastMessage", c.log.entries().empty() ? "" : c.log.entries().back().diagnostic.message},
        {"widgets", widgets},
    };
    // Not writeFileAtomically: it flushes to disk, which is too slow for every frame.
    const std::filesystem::path temporary = file.string() + ".next";
    if (!notRegular(temporary).empty()) {
        return; // writing to a pipe could wait for ever
    }
    std::ofstream(temporary) << json.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
    std::error_code ignored;
    std::filesystem::rename(temporary, file, ignored);
}

} // namespace forefront
