-- Lengths in metres in the frame of the map a row belongs to, times in UNIX seconds. A box is the MultiPoint of its
-- lowest and highest corner: its bounds are the box. Maps lie one over the other, each in its own frame, so indices of
-- places begin with the map.
CREATE EXTENSION IF NOT EXISTS btree_gist SCHEMA public;
CREATE TABLE robots (id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY, name text NOT NULL UNIQUE);
CREATE TABLE storeys (
  id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY, site text NOT NULL, name text NOT NULL, UNIQUE (site, name));

CREATE TABLE maps (
  id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
  robot bigint NOT NULL REFERENCES robots, name text NOT NULL, storey bigint NOT NULL REFERENCES storeys,
  parent bigint REFERENCES maps,  -- the map it goes on from
  -- Takes points of the map into the frame of the storey; null: not known.
  x_m float8, y_m float8, z_m float8, qx float8, qy float8, qz float8, qw float8,
  first_s float8 NOT NULL DEFAULT 0, last_s float8 NOT NULL DEFAULT 0,
  digest text NOT NULL DEFAULT '', size_bytes bigint NOT NULL DEFAULT 0,  -- of the file
  pushed_at timestamptz NOT NULL DEFAULT clock_timestamp(),
  UNIQUE (robot, name), CHECK (num_nulls(x_m, y_m, z_m, qx, qy, qz, qw) IN (0, 7)));
CREATE INDEX maps_of_storey ON maps (storey, last_s);

-- Pieces of files, each once, whosever files they are in; they come before the push that makes a file of them.
CREATE TABLE chunks (
  digest text PRIMARY KEY, bytes bytea NOT NULL, sent_at timestamptz NOT NULL DEFAULT clock_timestamp());
ALTER TABLE chunks ALTER COLUMN bytes SET STORAGE EXTERNAL;  -- compressed as they are
CREATE TABLE file_chunks (
  map bigint NOT NULL REFERENCES maps, position integer NOT NULL, digest text NOT NULL REFERENCES chunks,
  PRIMARY KEY (map, position));
CREATE INDEX file_chunks_by_digest ON file_chunks (digest);

CREATE TABLE labels (
  map bigint NOT NULL REFERENCES maps, class_id smallint NOT NULL, name text NOT NULL, PRIMARY KEY (map, class_id));
CREATE TABLE runs (
  map bigint NOT NULL REFERENCES maps, number integer NOT NULL, first_s float8 NOT NULL, last_s float8 NOT NULL,
  keyframes integer NOT NULL, way geometry(LineStringZM), PRIMARY KEY (map, number));
CREATE INDEX runs_by_way ON runs USING gist (map, way gist_geometry_ops_nd);
CREATE TABLE keyframes (
  map bigint NOT NULL REFERENCES maps, number bigint NOT NULL, run integer NOT NULL, stamp_s float8 NOT NULL,
  place geometry(PointZ) NOT NULL, qx float8 NOT NULL, qy float8 NOT NULL, qz float8 NOT NULL, qw float8 NOT NULL,
  zone text NOT NULL, digest text NOT NULL,  -- of the row, to tell what a push changes
  PRIMARY KEY (map, number));
CREATE TABLE zones (
  map bigint NOT NULL REFERENCES maps, position integer NOT NULL, name text NOT NULL, area geometry(Polygon) NOT NULL,
  rule json NOT NULL, PRIMARY KEY (map, position));
CREATE INDEX zones_by_area ON zones USING gist (map, area);
CREATE TABLE rooms (
  map bigint NOT NULL REFERENCES maps, number integer NOT NULL, name text NOT NULL,
  area geometry(MultiPolygon) NOT NULL, digest text NOT NULL, PRIMARY KEY (map, number));
CREATE INDEX rooms_by_area ON rooms USING gist (map, area);
-- The room around a place, by the rooms as they are known now: they get other numbers and outlines as more is seen, so
-- what stood there has no room written beside it. At most building::kRoomReach_m away.
CREATE FUNCTION room_at(map bigint, place geometry) RETURNS text LANGUAGE sql STABLE AS $$
  SELECT name FROM wardslam.rooms WHERE rooms.map = $1 AND ST_DWithin(area, $2, 0.5)
  ORDER BY ST_Distance(area, $2), number LIMIT 1
$$;
CREATE TABLE floor_plans (
  map bigint PRIMARY KEY REFERENCES maps, resolution_m float8 NOT NULL, origin_x_m float8 NOT NULL,
  origin_y_m float8 NOT NULL, rows integer NOT NULL, columns integer NOT NULL, digest text NOT NULL,
  cells bytea NOT NULL);  -- row by row: 0 free, 100 occupied, 255 unknown

CREATE SEQUENCE things;  -- a thing in several maps, each gone on from the other, is one
CREATE TABLE objects (
  map bigint NOT NULL REFERENCES maps, number bigint NOT NULL, thing bigint NOT NULL, in_map boolean NOT NULL,
  class_id smallint NOT NULL, probability float8 NOT NULL,
  place geometry(PointZ) NOT NULL, box geometry(MultiPointZ) NOT NULL,
  box_x_m float8 NOT NULL, box_y_m float8 NOT NULL, box_z_m float8 NOT NULL,
  box_qx float8 NOT NULL, box_qy float8 NOT NULL, box_qz float8 NOT NULL, box_qw float8 NOT NULL,
  box_length_m float8 NOT NULL, box_width_m float8 NOT NULL, box_height_m float8 NOT NULL,
  first_seen_s float8 NOT NULL, last_seen_s float8 NOT NULL, views integer NOT NULL, zone text NOT NULL,
  state text NOT NULL CHECK (state IN ('static', 'moved', 'gone')), maybe_same_as bigint, maybe_probability float8,
  digest text NOT NULL, PRIMARY KEY (map, number));
CREATE INDEX objects_by_thing ON objects (thing);
CREATE INDEX objects_by_place ON objects USING gist (map, place gist_geometry_ops_nd);
CREATE INDEX objects_by_box ON objects USING gist (map, box gist_geometry_ops_nd);

-- An object stood there from the first to the last time it was seen there. ended_s: when it was known to be elsewhere
-- or gone.
CREATE TABLE sightings (
  map bigint NOT NULL, object bigint NOT NULL, since_s float8 NOT NULL, until_s float8 NOT NULL,
  place geometry(PointZ) NOT NULL, box geometry(MultiPointZ) NOT NULL, zone text NOT NULL,
  ended text CHECK (ended IN ('moved', 'gone')), ended_s float8,
  PRIMARY KEY (map, object, since_s), FOREIGN KEY (map, object) REFERENCES objects,
  CHECK (since_s <= until_s), CHECK ((ended IS NULL) = (ended_s IS NULL)));
CREATE INDEX sightings_by_place ON sightings USING gist (map, place gist_geometry_ops_nd);
CREATE INDEX sightings_by_end ON sightings (map, ended_s) WHERE ended IS NOT NULL;

CREATE TABLE pushes (
  id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY, map bigint NOT NULL REFERENCES maps,
  at timestamptz NOT NULL DEFAULT clock_timestamp(), digest text NOT NULL);
CREATE TABLE changes (
  push bigint NOT NULL REFERENCES pushes, object bigint NOT NULL, map bigint NOT NULL,
  kind text NOT NULL CHECK (kind IN ('new', 'moved', 'gone', 'back')), at_s float8 NOT NULL,
  place geometry(PointZ) NOT NULL, zone text NOT NULL, zone_before text,
  PRIMARY KEY (push, object), FOREIGN KEY (map, object) REFERENCES objects);

CREATE VIEW whereabouts AS  -- for people with a database client
SELECT storeys.site, storeys.name AS storey, robots.name AS robot, maps.name AS map, objects.thing, objects.number,
       labels.name AS class, to_timestamp(sightings.since_s) AS since, to_timestamp(sightings.until_s) AS until,
       sightings.place, sightings.box, sightings.zone,
       room_at(sightings.map, sightings.place) AS room, sightings.ended,
       to_timestamp(sightings.ended_s) AS ended_at
FROM sightings
JOIN objects ON objects.map = sightings.map AND objects.number = sightings.object
JOIN maps ON maps.id = sightings.map
JOIN robots ON robots.id = maps.robot
JOIN storeys ON storeys.id = maps.storey
LEFT JOIN labels ON labels.map = objects.map AND labels.class_id = objects.class_id;
