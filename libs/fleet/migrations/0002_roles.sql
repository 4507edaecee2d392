-- Roles belong to the server, not to the database: they may be there, or be made by another database at this moment.
DO $$
BEGIN
  CREATE ROLE wardslam_reader NOLOGIN;
EXCEPTION WHEN duplicate_object OR unique_violation THEN NULL;
END $$;
DO $$
BEGIN
  CREATE ROLE wardslam_robot NOLOGIN;
EXCEPTION WHEN duplicate_object OR unique_violation THEN NULL;
END $$;

GRANT USAGE ON SCHEMA wardslam TO wardslam_reader, wardslam_robot;
GRANT SELECT ON ALL TABLES IN SCHEMA wardslam TO wardslam_reader, wardslam_robot;
GRANT INSERT ON robots, storeys, maps, chunks, file_chunks, labels, runs, keyframes, zones, rooms, floor_plans, objects,
  sightings, pushes, changes TO wardslam_robot;
GRANT UPDATE ON maps, chunks, file_chunks, labels, keyframes, rooms, floor_plans, objects, sightings TO wardslam_robot;
-- What a map is made of anew; never what has been.
GRANT DELETE ON chunks, file_chunks, labels, runs, keyframes, zones, rooms TO wardslam_robot;
GRANT USAGE ON SEQUENCE things TO wardslam_robot;
