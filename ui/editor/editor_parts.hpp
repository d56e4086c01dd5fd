#pragma once

#include "ui/dialogs/recovery.hpp"
#include "ui/dialogs/script_recording.hpp"
#include "ui/editor/canvas_input.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/imgui_bridge.hpp"
#include "ui/editor/snapshot_pace.hpp"
#include "ui/shell/canvas.hpp"
#include "ui/shell/start_page.hpp"
#include "ui/workspace/view/follow_camera.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

/// What an editor consists of, and the stages of a frame.
struct Editor::Parts {
    Parts(Platform &platform, EditorSetup given)
        : options(std::move(given)), bridge(platform), context(platform), canvas(context.background) {}

    EditorSetup options;
    InputQueue input;
    ImGuiBridge bridge;
    Shell context;
    Canvas canvas;
    CanvasInput canvasInput;
    shell::StartPage startPage;
    FollowCamera follower;
    ScriptRecording recording;
    std::unique_ptr<Recovery> recovery; ///< null: no journal is kept
    Settings savedSettings;
    bool reopening = false; ///< the last projects are being opened and shown, one after the other
    /// Those of them that were opened and are not shown at rest yet. They are left out of the saved settings: one that
    /// ends the program must not do so at every start.
    std::vector<std::string> unproven;
    std::string shownTitle;
    double lastFrame = 0.0;
    std::uint64_t frames = 0;
    std::uint64_t flagRevision = 0; ///< revision of the document that the view's flag refers to
    PixelSize size;
    SnapshotPace pace;
    double lastEnd = 0.0;          ///< steady time when the last frame ended
    double previewTaken = 0.0;     ///< steady time when a preview or raster was last taken
    bool drewNews = false;         ///< this frame draws a new snapshot, or a part of it
    double newsSeconds = 0.0;      ///< that drawing the new snapshot has taken
    bool showedCancelling = false; ///< a frame that shows the cancelling has been presented
    bool drewBusy = false;         ///< the last frame showed a run as busy
    bool reportedBusy = false;     ///< the state file says that the editor has not settled

    bool newsDue() const;
    bool previewDue() const;
    bool due(NewsPace news) const;
    double untilTurn() const;
    bool gestureUnderWay() const;
    bool keySharesFrame(const InputEvent &event) const;
    void refreshLook();
    void takeResults(bool cancels);
    void dropFlag();
    void followDocument();
    void followFront(double seconds);
    void handleEvents(const std::vector<InputEvent> &events);
    void buildInterface();
    void showTitle();
    bool inputWaits() const;
    std::vector<InputEvent> takeInput();
    void recordFrame(double begin, bool cancelling, bool busy);
    void rememberSettings();
};

} // namespace forefront
