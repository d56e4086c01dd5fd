#include "ui/tools/make_tools.hpp"

#include "ui/tools/draw/arc_tool.hpp"
#include "ui/tools/draw/box_tool.hpp"
#include "ui/tools/draw/outline_tool.hpp"
#include "ui/tools/draw/pen_tool.hpp"
#include "ui/tools/draw/point_tool.hpp"
#include "ui/tools/draw/region_tool.hpp"
#include "ui/tools/draw/round_tools.hpp"
#include "ui/tools/draw/slot_tool.hpp"
#include "ui/tools/draw/trim_tool.hpp"
#include "ui/tools/look/guess_tool.hpp"
#include "ui/tools/look/measure_tool.hpp"
#include "ui/tools/look/picture_tool.hpp"
#include "ui/tools/look/probe_tool.hpp"
#include "ui/tools/look/trace_tool.hpp"
#include "ui/tools/select/select_tool.hpp"
#include "ui/tools/size/brush_tool.hpp"
#include "ui/tools/size/gradient_tool.hpp"
#include "ui/tools/size/source_tool.hpp"

namespace forefront {

std::vector<std::unique_ptr<Tool>> makeTools() {
    const auto state = std::make_shared<EditState>();
    std::vector<std::unique_ptr<Tool>> tools;
    tools.push_back(std::make_unique<SelectTool>(state));
    tools.push_back(std::make_unique<PenTool>(state, ShapeKind::Polygon));
    tools.push_back(std::make_unique<BoxTool>(state, ShapeKind::Rectangle));
    tools.push_back(std::make_unique<BoxTool>(state, ShapeKind::Circle));
    tools.push_back(std::make_unique<BoxTool>(state, ShapeKind::Ellipse));
    tools.push_back(std::make_unique<RegularPolygonTool>(state));
    tools.push_back(std::make_unique<SlotTool>(state));
    tools.push_back(std::make_unique<PenTool>(state, ShapeKind::Polyline));
    tools.push_back(std::make_unique<ArcTool>(state));
    tools.push_back(std::make_unique<PointTool>(state));
    tools.push_back(std::make_unique<TrimTool>(state));
    tools.push_back(std::make_unique<RegionTool>(state));
    tools.push_back(std::make_unique<BrushTool>(state, false));
    tools.push_back(std::make_unique<BrushTool>(state, true));
    tools.push_back(std::make_unique<SourceTool>(state));
    tools.push_back(std::make_unique<GradientTool>(state));
    tools.push_back(std::make_unique<MeasureTool>(state));
    tools.push_back(std::make_unique<PictureTool>(state));
    tools.push_back(std::make_unique<OutlineTool>(state));
    tools.push_back(std::make_unique<TraceTool>());
    tools.push_back(std::make_unique<ProbeTool>());
    tools.push_back(std::make_unique<GuessTool>());
    return tools;
}

} // namespace forefront
