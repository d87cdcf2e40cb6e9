#include "physics/cell_model.h"

namespace morula {

extern const CellModelKind shellCells, shapeMatchingCells, sphereCells;

const CellModelKind& kindOf(CellModel model) {
  switch (model) {
    case CellModel::shell: return shellCells;
    case CellModel::shapeMatching: return shapeMatchingCells;
    case CellModel::sphere: return sphereCells;
  }
  return shellCells;
}

}  // namespace morula
