-- A file of results as the first version of the tables had it.
PRAGMA application_id = 1299344481;
PRAGMA user_version = 1;
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

INSERT INTO run VALUES ('0123456789abcdef', 'old', 7, 'done', '000102030405060708090a0b0c0d0e0f', '2026-01-02T03:04:05Z',
  '2026-01-02T03:05:06Z', 700, 2, 1.5, NULL, 'fedcba9876543210fedcba9876543210', 'b1b2b3b4b5b6b7b8b1b2b3b4b5b6b7b8', '0.1.0',
  'a1a2a3a4a5a6a7a8a1a2a3a4a5a6a7a8', 'unknown', 'unknown', 'GNU 12.2.0', 'Release -O3', 'Linux x86_64', 'SQLite 3.40.1',
  'a processor', 'a kernel', 'avx2', 1, 'morula run old.yaml');
INSERT INTO document VALUES ('d1', x'6d6f72756c613a20310a');
INSERT INTO run_document VALUES ('0123456789abcdef', 0, 'scenario', 'old.yaml', 'd1');
INSERT INTO cell VALUES ('0123456789abcdef', '', NULL, 0.0, 1.0, 'divided', 'a0', NULL, 0, 512);
INSERT INTO cell VALUES ('0123456789abcdef', 'A', '', 1.0, NULL, 'alive', 'A a1', NULL, 512, NULL);
INSERT INTO cell VALUES ('0123456789abcdef', 'B', '', 1.0, NULL, 'alive', 'B a1', NULL, 512, NULL);
INSERT INTO step_hash VALUES ('0123456789abcdef', 64, '000102030405060708090a0b0c0d0e0f');
