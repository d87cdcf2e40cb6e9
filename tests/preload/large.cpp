// Replaces OSMesa by a library that does not load for lack of address space.
char large[1ul << 48];
