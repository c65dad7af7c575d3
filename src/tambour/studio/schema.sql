-- The library. A revision is what a piece is made of; nothing that can be made again is kept but small pictures.
CREATE TABLE blob (
  sha256 TEXT PRIMARY KEY,
  bytes  BLOB NOT NULL,
  size   INTEGER NOT NULL
) WITHOUT ROWID;

CREATE TABLE piece (
  id      TEXT PRIMARY KEY,
  craft   TEXT NOT NULL,
  title   TEXT NOT NULL,
  made    INTEGER NOT NULL,
  changed INTEGER NOT NULL,
  head    INTEGER REFERENCES revision ON DELETE SET NULL,
  thumb   INTEGER,                         -- the revision that the picture is of
  picture TEXT REFERENCES blob,
  binned  INTEGER
);

CREATE TABLE revision (
  id      INTEGER PRIMARY KEY AUTOINCREMENT,
  piece   TEXT NOT NULL REFERENCES piece ON DELETE CASCADE,
  parent  INTEGER REFERENCES revision ON DELETE SET NULL,
  next    INTEGER REFERENCES revision ON DELETE SET NULL,  -- where redo leads
  name    TEXT,                            -- of its source
  source  TEXT REFERENCES blob,
  params  TEXT NOT NULL,
  files   TEXT NOT NULL,                   -- field -> name and sha256
  edits   TEXT NOT NULL,
  edition INTEGER NOT NULL,
  version TEXT NOT NULL,
  at      INTEGER NOT NULL,
  said    TEXT NOT NULL
);

CREATE TABLE place (
  piece TEXT PRIMARY KEY REFERENCES piece ON DELETE CASCADE,
  step  INTEGER NOT NULL,
  unit  INTEGER NOT NULL,
  at    INTEGER NOT NULL
);

CREATE INDEX revision_of ON revision(piece, id);
CREATE INDEX piece_changed ON piece(binned, changed DESC, id);
