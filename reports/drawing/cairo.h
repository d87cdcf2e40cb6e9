#pragma once
// cairo's objects and errors, as the files of this module share them.
#include <cairo.h>

#include <memory>
#include <string>

#include "base/error.h"
#include "image/colour.h"

namespace morula {

template <auto destroy>
struct CairoDestroy {
  template <class T>
  void operator()(T* object) const {
    destroy(object);
  }
};
template <class T, auto destroy>
using CairoPointer = std::unique_ptr<T, CairoDestroy<destroy>>;

using Surface = CairoPointer<cairo_surface_t, cairo_surface_destroy>;
using Context = CairoPointer<cairo_t, cairo_destroy>;

/// Throws std::bad_alloc if memory ran out, else BugError: our arguments are checked, so other failures are bugs.
inline void requireSuccess(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS) throw BugError(std::string("cairo: ") + cairo_status_to_string(status));
}

inline void setColour(cairo_t* target, Colour c) {
  cairo_set_source_rgb(target, c.r / 255.0, c.g / 255.0, c.b / 255.0);
}

}  // namespace morula
