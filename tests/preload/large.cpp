// Loaded in the place of OSMesa, it fails as libraries do for which there is no address space.
char large[1ul << 48];
