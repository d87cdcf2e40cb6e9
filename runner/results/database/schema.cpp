#include "database/schema.h"

#include <array>

#include "database/measure_columns.h"
#include "database/store_error.h"

namespace morula {

namespace {

// Version 0 to 1: the first tables. A file of version v is brought up to date by the entries from v on; an
// entry that has been released is never edited. SQLite keeps the comments, so `.schema` explains the tables.
// - Keys stand first: SQLite 3.40's integrity check misreads tables WITHOUT ROWID in which they do not.
// - `fate` is compared value by value: to look into an IN of three values SQLite makes a table anew for each
//   row, which takes as long as storing the row.
const char* const version1 = R"sql(
CREATE TABLE run (
  run_id        TEXT PRIMARY KEY,   -- from scenario_hash, seed and build_id: the same computation, the same id
  scenario      TEXT NOT NULL,
  seed          INTEGER NOT NULL,   -- two's complement from 2^63 on
  status        TEXT NOT NULL CHECK (status IN ('running', 'done', 'failed', 'killed')),
  state_hash    TEXT,               -- of the final state, all bits; NULL unless done
  started       TEXT NOT NULL,      -- UTC
  ended         TEXT,               -- NULL while running
  steps         INTEGER,
  cells         INTEGER,            -- alive at the end
  time          REAL,               -- simulated
  failure       TEXT,               -- why a failed run stopped
  scenario_hash TEXT NOT NULL,      -- of the meaning: formatting and key order do not count
  build_id      TEXT NOT NULL,      -- from sources, compiler, flags, target and libraries
  version       TEXT NOT NULL,
  sources       TEXT NOT NULL,      -- digest of the program's sources
  git_commit    TEXT NOT NULL,
  git_state     TEXT NOT NULL CHECK (git_state IN ('clean', 'modified', 'unknown')),
  compiler      TEXT NOT NULL,
  flags         TEXT NOT NULL,
  target        TEXT NOT NULL,
  libraries     TEXT NOT NULL,      -- 'Eigen 3.4.0; SQLite 3.40.1'
  cpu           TEXT NOT NULL,
  kernel        TEXT NOT NULL,
  isa           TEXT NOT NULL,      -- changes no result
  threads       INTEGER NOT NULL,   -- changes no result
  command       TEXT NOT NULL
) STRICT;

-- Texts that decided runs, each stored once however many runs share it.
CREATE TABLE document (
  hash    TEXT PRIMARY KEY,
  content BLOB NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE run_document (
  run_id TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  number INTEGER NOT NULL,
  role   TEXT NOT NULL,             -- scenario (as read), resolved (defaults and overrides filled in), dna, mesh
  path   TEXT NOT NULL,
  hash   TEXT NOT NULL REFERENCES document,
  PRIMARY KEY (run_id, number)
) STRICT, WITHOUT ROWID;

CREATE TABLE cell (
  run_id     TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  path       TEXT NOT NULL,         -- '' the egg, then A and B
  parent     TEXT,                  -- NULL for the egg
  born       REAL NOT NULL,
  ended      REAL,                  -- NULL while alive
  fate       TEXT NOT NULL CHECK (fate = 'divided' OR fate = 'died' OR fate = 'alive'),
  state      TEXT NOT NULL,         -- its last substances, sorted, separated by spaces
  name       TEXT,
  born_step  INTEGER NOT NULL,
  ended_step INTEGER,
  PRIMARY KEY (run_id, path)
) STRICT, WITHOUT ROWID;

-- Measured numbers: NULL where there was nothing to measure, or where the number was not one.
CREATE TABLE sample (
  run_id         TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  time           REAL NOT NULL,
  cells          INTEGER NOT NULL,
  step           INTEGER NOT NULL,
  volume         REAL,              -- of all cells
  kinetic_energy REAL,
  mean_pressure  REAL,
  shell_fill     REAL,              -- volume / the shell's volume
  outermost      REAL,              -- the farthest vertex, 1 on the shell
  PRIMARY KEY (run_id, time)
) STRICT, WITHOUT ROWID;

CREATE TABLE cell_sample (
  run_id     TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  time       REAL NOT NULL,
  path       TEXT NOT NULL,
  volume     REAL,
  area       REAL,
  pressure   REAL,                  -- inside minus outside
  x          REAL,
  y          REAL,
  z          REAL,
  sphericity REAL,
  neighbours INTEGER NOT NULL,
  state      TEXT NOT NULL,
  PRIMARY KEY (run_id, time, path)
) STRICT, WITHOUT ROWID;

CREATE TABLE contact (
  run_id TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  time   REAL NOT NULL,
  a      TEXT NOT NULL,
  b      TEXT NOT NULL,
  area   REAL,
  PRIMARY KEY (run_id, time, a, b)
) STRICT, WITHOUT ROWID;

CREATE TABLE connection (
  run_id   TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  number   INTEGER NOT NULL,        -- in the order of making
  a        TEXT NOT NULL,
  b        TEXT NOT NULL,
  made     REAL NOT NULL,
  released REAL,                    -- NULL while it holds
  cause    TEXT NOT NULL,           -- of the release: '', divided, died, distance, gene
  PRIMARY KEY (run_id, number)
) STRICT, WITHOUT ROWID;

CREATE TABLE time_step (            -- the first row is the start, each further one a change
  run_id    TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  step      INTEGER NOT NULL,
  time      REAL NOT NULL,
  time_step REAL NOT NULL,          -- in force from here on
  PRIMARY KEY (run_id, step)
) STRICT, WITHOUT ROWID;

CREATE TABLE step_hash (
  run_id TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  step   INTEGER NOT NULL,
  hash   TEXT NOT NULL,
  PRIMARY KEY (run_id, step)
) STRICT, WITHOUT ROWID;

CREATE TABLE check_result (
  run_id             TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  number             INTEGER NOT NULL,
  "check"            TEXT NOT NULL,
  kind               TEXT NOT NULL CHECK (kind IN ('golden', 'bullet', 'invariant')),
  expected           TEXT NOT NULL,
  actual             TEXT NOT NULL,
  tolerance          TEXT NOT NULL,
  passed             INTEGER NOT NULL CHECK (passed IN (0, 1)),
  class              TEXT NOT NULL, -- '' when passed
  first_step         INTEGER,
  cell               TEXT,
  field              TEXT NOT NULL,
  share_of_tolerance REAL,
  message            TEXT NOT NULL,
  PRIMARY KEY (run_id, number)
) STRICT, WITHOUT ROWID;
)sql";

// Version 1 to 2: hashes of each part and each cell; what a run that was stopped goes on from; more about the
// program and the machine. A version 1 hash was of the state alone and of another make, so none is kept.
const char* const version2 = R"sql(
DROP TABLE step_hash;
CREATE TABLE step_hash (
  run_id      TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  step        INTEGER NOT NULL,
  hash        TEXT NOT NULL,        -- a chain: over the row before, the step and the state
  state       TEXT NOT NULL,        -- over all parts
  clock       TEXT NOT NULL,
  connections TEXT NOT NULL,        -- zeros where nothing connects
  lineage     TEXT NOT NULL,
  PRIMARY KEY (run_id, step)
) STRICT, WITHOUT ROWID;

CREATE TABLE cell_hash (            -- of each living cell at each step of step_hash: biology and body
  run_id TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  step   INTEGER NOT NULL,
  path   TEXT NOT NULL,
  hash   TEXT NOT NULL,
  PRIMARY KEY (run_id, step, path)
) STRICT, WITHOUT ROWID;

ALTER TABLE run ADD COLUMN
  binary_hash TEXT NOT NULL DEFAULT 'unknown';    -- XXH3-128 of the program's file
ALTER TABLE run ADD COLUMN
  fp_environment TEXT NOT NULL DEFAULT 'unknown'; -- how the processor rounds, and what it does with denormals
ALTER TABLE run ADD COLUMN
  cpu_features TEXT NOT NULL DEFAULT 'unknown';   -- those that arithmetic can hang on

CREATE TABLE checkpoint (            -- of a run that has not finished; the next one replaces it
  run_id     TEXT PRIMARY KEY REFERENCES run ON DELETE CASCADE,
  step       INTEGER NOT NULL,       -- samples and hashes up to this step are in their tables
  made       TEXT NOT NULL,          -- UTC
  every      REAL,                   -- between samples; NULL: none are taken
  hash_every INTEGER,                -- steps between hashes; NULL: none are taken
  state      BLOB NOT NULL           -- core/simulation/checkpoint.h
) STRICT;

CREATE TABLE checkpoint_frame (      -- shapes for a sequence of pictures, until it is drawn
  run_id  TEXT NOT NULL REFERENCES checkpoint ON DELETE CASCADE,
  number  INTEGER NOT NULL,
  content BLOB NOT NULL,
  PRIMARY KEY (run_id, number)
) STRICT;
)sql";

// Version 2 to 3: what Bullet made of the same scene, where a scenario's check asks for it.
const char* const version3 = R"sql(
CREATE TABLE bullet_sample (
  run_id     TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  time       REAL NOT NULL,          -- time and path as in cell_sample
  path       TEXT NOT NULL,
  baseline   TEXT NOT NULL,          -- b1 or b3
  volume     REAL,
  area       REAL,
  pressure   REAL,
  x          REAL,
  y          REAL,
  z          REAL,
  sphericity REAL,
  PRIMARY KEY (run_id, time, path)
) STRICT, WITHOUT ROWID;
)sql";

// Version 3 to 4: how each cell was cut, and a further kind of check: what every run with bodies is held to.
// SQLite cannot change a constraint, so the table of checks is made anew.
const char* const version4 = R"sql(
CREATE TABLE division (
  run_id       TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  path         TEXT NOT NULL,        -- of the mother
  time         REAL NOT NULL,
  step         INTEGER NOT NULL,
  axis_x       REAL NOT NULL,        -- unit normal of the plane; points to daughter A
  axis_y       REAL NOT NULL,
  axis_z       REAL NOT NULL,
  share        REAL NOT NULL,        -- of the mother's volume that daughter A has
  extent_ratio REAL,                 -- of the mother's two largest extents; towards 1 it is ambiguous which is the longest
  PRIMARY KEY (run_id, path)
) STRICT, WITHOUT ROWID;

CREATE TABLE check_result_4 (
  run_id             TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  number             INTEGER NOT NULL,
  "check"            TEXT NOT NULL,
  kind               TEXT NOT NULL CHECK (kind IN ('golden', 'bullet', 'invariant', 'sanity')),
  expected           TEXT NOT NULL,
  actual             TEXT NOT NULL,
  tolerance          TEXT NOT NULL,
  passed             INTEGER NOT NULL CHECK (passed IN (0, 1)),
  class              TEXT NOT NULL, -- '' when passed
  first_step         INTEGER,
  cell               TEXT,
  field              TEXT NOT NULL,
  share_of_tolerance REAL,
  message            TEXT NOT NULL,
  PRIMARY KEY (run_id, number)
) STRICT, WITHOUT ROWID;
INSERT INTO check_result_4 SELECT * FROM check_result;
DROP TABLE check_result;
ALTER TABLE check_result_4 RENAME TO check_result;
)sql";

// Version 4 to 5: nothing but measures that join their table, whose columns are added where they are missing
// (measure_columns.h). Programs before it write rows by position, and would fail on them.
const char* const version5 = "";

// Version 5 to 6: measures on demand, which a scenario's record names, one value a row.
const char* const version6 = R"sql(
CREATE TABLE measure (
  run_id TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  time   REAL NOT NULL,              -- as in sample
  scope  TEXT NOT NULL CHECK (scope = 'world' OR scope = 'cell' OR scope = 'pair'),
  name   TEXT NOT NULL,              -- of scenarios/MEASURES.md
  a      TEXT NOT NULL,              -- the cell's path, or the pair's first; '' of the world
  b      TEXT NOT NULL,              -- the pair's second; '' of the world and a cell
  value  REAL,
  PRIMARY KEY (run_id, time, scope, name, a, b)
) STRICT, WITHOUT ROWID;
)sql";

// Version 6 to 7: which condition of a study a run is of. The tables of a study (study_store/study_tables.h) join where there is one.
const char* const version7 = R"sql(
ALTER TABLE run ADD COLUMN
  condition_id INTEGER;              -- of a study's merged database; NULL elsewhere
)sql";

// Version 7 to 8: surfaces of cells, where a scenario's record keeps them; the faces of mesh m are the run's document with the role faces
// and the path m: three corners a face from 0, little-endian, 16 bits each up to 65536 vertices, else 32. A table with row numbers: SQLite fits rows of this size
// four to a page, and in tables without them one row a page.
const char* const version8 = R"sql(
CREATE TABLE mesh_sample (
  run_id   TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  time     REAL NOT NULL,            -- as in sample
  path     TEXT NOT NULL,
  mesh     INTEGER NOT NULL,         -- 0 the egg's, 1 ... the coarser ones
  low_x    REAL NOT NULL,            -- x of a vertex = low_x + number * step_x, off by at most step_x / 2
  low_y    REAL NOT NULL,
  low_z    REAL NOT NULL,
  step_x   REAL NOT NULL,            -- a 65535th of the extent along x
  step_y   REAL NOT NULL,
  step_z   REAL NOT NULL,
  vertices BLOB NOT NULL,            -- the numbers of x, y and z of each vertex, 16 bits each, little-endian
  PRIMARY KEY (run_id, time, path)
) STRICT;
)sql";

constexpr std::array migrations{&version1, &version2, &version3, &version4,
                                &version5, &version6, &version7, &version8};

/// Throws unless the file is empty or Morula's and not newer than this program. Returns its version, 0 when empty.
int checkedVersion(Database& db) {
  const std::string file = db.file().string();
  const auto id = db.integer("PRAGMA application_id");
  const auto version = static_cast<int>(db.integer("PRAGMA user_version"));  // 32 bits in the file
  if (id == 0 && version == 0 && db.integer("SELECT count(*) FROM sqlite_schema") == 0) return 0;
  if (id != applicationId)
    throw StoreError(file + ": a database, but not one of Morula's (application_id " + std::to_string(id) +
                     "); give another file");
  if (version < 0)
    throw StoreError(file + ": the file is damaged: there is no database version " + std::to_string(version) +
                     "; give another file, or restore it from a copy");
  if (version > schemaVersion())
    throw StoreError(file + ": written by a newer Morula (database version " + std::to_string(version) +
                     ", this program knows up to " + std::to_string(schemaVersion()) +
                     "); use the newer program, or give another file");
  return version;
}

}  // namespace

int schemaVersion() { return static_cast<int>(migrations.size()); }

void configure(Database& db) {
  db.execute("PRAGMA foreign_keys = ON");
  db.execute("PRAGMA synchronous = FULL");
  db.execute("PRAGMA cache_size = -65536");  // 64 MiB: a large run's rows need not be written twice
  // The rollback journal is SQLite's own default. Write-ahead logs lose data with several writers before
  // SQLite 3.51.3 and do not work on network disks, so a file that was switched to them is switched back.
  if (!db.readOnly()) db.execute("PRAGMA journal_mode = DELETE");
}

void migrate(Database& db) {
  if (checkedVersion(db) == schemaVersion() && hasMeasureColumns(db)) return;
  if (db.readOnly())
    throw StoreError(db.file().string() +
                     ": the file is not writable; change its permissions or give another file");
  Transaction transaction(db);
  const int version = checkedVersion(db);  // again: another process may have been faster
  for (int v = version; v < schemaVersion(); ++v) db.execute(*migrations[static_cast<std::size_t>(v)]);
  addMeasureColumns(db);
  db.execute("PRAGMA application_id = " + std::to_string(applicationId));
  db.execute("PRAGMA user_version = " + std::to_string(schemaVersion()));
  transaction.commit();
}

void requireCurrentSchema(Database& db) {
  const int version = checkedVersion(db);
  if (version == 0)
    throw StoreError(db.file().string() + ": the file is empty; a database of results is expected");
  if (version < schemaVersion())
    throw StoreError(db.file().string() + ": written by an older Morula (database version " +
                     std::to_string(version) + "); run something into it, which brings it up to date");
}

}  // namespace morula
