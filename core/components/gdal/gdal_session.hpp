#pragma once

#include "core/files/components/gdal_component.hpp"

#include <gdal.h>
#include <memory>
#include <ogr_srs_api.h>
#include <string>

namespace forefront::gdal {

template <auto Release>
struct Releaser {
    template <class T>
    void operator()(T *item) const {
        Release(item);
    }
};

using Dataset = std::unique_ptr<void, Releaser<GDALClose>>;
using ReferenceSystem = std::unique_ptr<void, Releaser<OSRDestroySpatialReference>>;

/// Registers the drivers once, and collects the messages of GDAL on this thread in a report instead of printing them.
class Session {
  public:
    explicit Session(GdalReport &report);
    ~Session();
    Session(const Session &) = delete;
    Session &operator=(const Session &) = delete;

    /// Opens a file; null, with a message, if it cannot be read. `flags`: as for GDALOpenEx.
    Dataset open(const GdalFile &file, unsigned flags);
    /// Records a failure with the last error of GDAL; returns false.
    bool fail(const std::string &what, const std::string &advice = {});
    /// Returns the reference system with this name, its axes x (or longitude) first; null, with a message, if it is
    /// unknown.
    ReferenceSystem named(const std::string &name);

  private:
    GdalReport &report_;
    std::string lastError_;
    std::string memoryFile_; ///< its name in GDAL's file system; empty: none

    static void CPL_STDCALL collect(CPLErr kind, CPLErrorNum number, const char *text);
};

} // namespace forefront::gdal
