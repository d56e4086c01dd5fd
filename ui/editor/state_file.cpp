#include "ui/editor/state_file.hpp"

#include "core/engine/base/hash.hpp"
#include "core/files/json/json_writer.hpp"
#include "core/files/source/source.hpp"
#include "ui/editor/editor.hpp"
#include "ui/parts/shell.hpp"

#include <array>
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
    Shell &c = editor.context();
    const SessionSnapshot &run = c.run.now();
    const Camera &camera = c.view.camera;
    JsonWriter json(JsonWriter::Layout::OneLine);
    json.beginObject();
    json.member("frame", editor.frames()).member("settled", editor.settled());
    json.member("tool", c.tools.current().id())
        .member("dialog", c.dialogs.top() != nullptr ? c.dialogs.top()->id() : "");
    json.member("workspace", presetOf(c.settings.workspace).word);
    json.member("revision", c.document.revision()).member("shapes", c.document.current()->shapes.size());
    json.member("paintedTiles", c.document.current()->spacing.paint.tiles.size());
    json.member("dirty", c.document.dirty()).member("outOfDate", c.run.outOfDate());
    json.key("camera").values(std::array{camera.centre.x, camera.centre.y, camera.zoom});
    json.key("run").beginObject().member("number", run.run).member("state", stateName(run.state));
    json.member("advance", run.advance).member("known", run.known).member("complete", run.complete);
    json.member("improveStep", run.improveStep).member("improveSteps", run.improveSteps);
    json.member("elements", run.quality.elements);
    json.member("stateHash", toHex(run.stateHash)).member("meshHash", toHex(run.meshHash)).endObject();
    json.member("messages", c.log.entries().size());
    json.member("lastMessage", c.log.entries().empty() ? "" : c.log.entries().back().diagnostic.message);
    json.key("widgets").beginObject();
    for (const auto &[name, widget] : c.widgets.all()) {
        json.key(name).values(std::array{std::lround(widget.rect.x), std::lround(widget.rect.y),
                                         std::lround(widget.rect.width), std::lround(widget.rect.height),
                                         widget.enabled ? 1L : 0L});
    }
    json.endObject().endObject();
    // Not writeFileAtomically: it flushes to disk, which is too slow for every frame.
    const std::filesystem::path temporary = file.string() + ".next";
    if (!notRegular(temporary).empty()) {
        return; // writing to a pipe could wait for ever
    }
    std::ofstream(temporary) << json.text();
    std::error_code ignored;
    std::filesystem::rename(temporary, file, ignored);
}

} // namespace forefront
