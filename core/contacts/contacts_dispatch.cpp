#include "contacts/contacts_kernels.h"

namespace morula {

MORULA_TABLES(ContactKernels, contacts, doubleTables, )
MORULA_TABLES(ContactKernels, contacts, singleTables, _single)

const ContactKernels& contactKernels(Isa isa, Precision precision) {
  return precision == Precision::binary64 ? doubleTables[isa] : singleTables[isa];
}

}  // namespace morula
