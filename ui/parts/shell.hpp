#pragma once

#include "ui/background/background_task.hpp"
#include "ui/background/file_watch.hpp"
#include "ui/parts/action.hpp"
#include "ui/parts/context_menu.hpp"
#include "ui/parts/dialog.hpp"
#include "ui/parts/dimension_entry.hpp"
#include "ui/parts/document_tabs.hpp"
#include "ui/parts/fix_trial.hpp"
#include "ui/parts/guide_drag.hpp"
#include "ui/parts/layer.hpp"
#include "ui/parts/menu_keys.hpp"
#include "ui/parts/naming.hpp"
#include "ui/parts/panel.hpp"
#include "ui/parts/settings.hpp"
#include "ui/parts/tool.hpp"
#include "ui/parts/unsaved_drawing.hpp"
#include "ui/workspace/run/adaptation.hpp"
#include "ui/workspace/run/side_by_side.hpp"
#include "ui/workspace/view/lesson_room.hpp"
#include "ui/workspace/view/page_images.hpp"
#include "ui/workspace/workspace.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

struct MeshExport;

/// The tools, and the index of the active one.
struct ToolBox {
    std::vector<std::unique_ptr<Tool>> tools;
    std::size_t active = 0;
    std::vector<std::size_t> left; ///< tools that were active before, the last one at the end; each once

    Tool &current() const { return *tools[active]; }
    void choose(std::string_view id, Shell &context);
    /// Lets the tools forget the previous document when another one was opened.
    void followDocument(Shell &context);

  private:
    std::uint64_t loads_ = 0; ///< see DocumentStore::loads()
};

/// What is open over the canvas for now.
struct Plates {
    bool start = false;   ///< the page with ways to begin, while the canvas is empty
    bool layers = false;  ///< the switches of the layers
    bool log = false;     ///< the drawer of the log
    bool history = false; ///< the list of the history
    bool options = false; ///< options of the tool that do not fit into their bar
    bool column = false;  ///< the column, in a window too narrow to dock it
};

/// The workspace and the parts of the window around it. Handed to tools, panels, dialogs and actions; owned by Editor.
struct Shell : Workspace {
    Settings settings;
    DocumentTabs tabs; ///< the documents that are open in this window
    ActionRegistry actions;
    DialogHost dialogs;
    ToolBox tools;
    std::vector<LayerSlot> layers;
    std::vector<std::unique_ptr<Panel>> panels;
    LessonRoom lessons;
    PageImages pageImages{background};
    double drawSeconds = 0.025; ///< per frame for drawing a large mesh; 0: one small piece a frame, for tests
    /// Id of the layer that coloured the canvas before showMeshColours(), or empty for none; absent: it is not in
    /// force.
    std::optional<std::string> coloursBefore;
    std::vector<std::string> called; ///< ids of panels that something has asked for, see showPanel()
    std::string revealedPanel;       ///< id of the panel to scroll to; empty: none
    Plates plates;
    std::vector<UnsavedDrawing> unsaved; ///< that can be recovered
    std::uint64_t newsDismissed = 0;     ///< number of the last entry when messages on the canvas were dismissed
    std::uint64_t logSeen = 0;           ///< number of the last entry of the log that was seen in its drawer
    /// Name of the file that the mesh of a document was exported to last, without its extension, and
    /// DocumentStore::loads() of the document.
    std::pair<std::string, std::uint64_t> exported;
    std::shared_ptr<const MeshExport> written; ///< a mesh that was written since the recording of a script last looked
    std::string recordedScript;                ///< name of the script that is being recorded; empty: none
    bool contextMenu = false;                  ///< a tool asks for the menu of the selection at the pointer
    ContextMenu menu;                          ///< see contextMenu; panels and tools can open other ones
    MenuKeys menuKeys;
    Naming naming;
    DimensionEntry dimensionEntry;
    GuideDrag rulerDrag;          ///< of a guide out of a ruler
    SideBySide sides{background}; ///< runs with other grids or the other method
    /// The workspace to go back to while the canvas and the ten steps are presented alone; absent: they are not.
    std::optional<WorkspaceKind> presentedFrom;
    std::optional<FixTrial> fixTrial; ///< a fix whose mesh is not judged yet
    bool quit = false;                ///< end the program after this frame
    bool closeRequested = false;      ///< the user closed the window; "file.quit" decides
    Adaptation adaptation{background};
    BackgroundTask task{background}; ///< reading a file
    FileWatch fileWatch{background}; ///< on the file of the document
    std::uint64_t watchedUse = 0;    ///< the DocumentStore::fileUses() that it watches

    using Workspace::Workspace;

    /// Returns the layer with this id, or null.
    LayerSlot *layer(std::string_view id);
};

/// Colours meshes by their quality, until the user chooses other layers or another document is opened.
void showMeshColours(Shell &context);
/// Shows the layer that showMeshColours() has replaced.
void restoreColours(Shell &context);

/// Cancels the background task, if there is one, and says so in the log.
void cancelTask(Shell &context);

} // namespace forefront
