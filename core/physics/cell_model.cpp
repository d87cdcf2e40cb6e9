#include "physics/cell_model.h"

namespace morula {

const CellModelKind& kindOf(CellModel model) {
  switch (model) {
    case CellModel::shell: return shellCells;
    case CellModel::shapeMatching: return shapeMatchingCells;
    case CellModel::sphere: return sphereCells;
  }
  return shellCells;
}

}  // namespace morula
