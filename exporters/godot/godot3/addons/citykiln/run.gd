# A run of citykiln on disk: reads report.json of its folder. `problem` is empty, or one line that says what is wrong.
extends Reference

const LAYERS = ["ground", "roads", "water", "buildings", "structures", "props", "plants"]

var folder = ""
var problem = ""
# tolerance and measured error in metres of each level, finest first
var levels = []
# of each file: "file" relative to the folder, "x", "y", "level"
var files = []
# names such as "0_-1"
var tiles = []
var attribution = []
# the run's day, its hour in UTC, and the longitude and latitude of its origin
var date = ""
var hour = 12.0
var origin = {}


func read(of_folder):
	folder = of_folder
	var path = folder.plus_file("report.json")
	var file = File.new()
	if file.open(path, File.READ) != OK:
		problem = "%s: no such file; expected the output folder of citykiln compile" % path
		return self
	var parsed = JSON.parse(file.get_as_text())
	if parsed.error != OK or typeof(parsed.result) != TYPE_DICTIONARY:
		problem = "%s:%d: expected JSON of citykiln" % [path, parsed.error_line + 1]
		return self
	take(parsed.result, path)
	return self


func take(report, path):
	for key in ["target", "levels", "tiles", "attribution", "origin", "sky"]:
		if not key in report:
			problem = "%s: lacks \"%s\"; expected the report of citykiln compile" % [path, key]
			return
	if not report["target"] in ["godot", "generic"] or report.get("compress", "none") != "none":
		problem = "%s: the tiles are for %s, compressed by %s; compile with --target godot and without --compress" % [
			path, report["target"], report.get("compress", "none")]
		return
	levels = report["levels"]
	attribution = report["attribution"]
	origin = report["origin"]
	take_time(report["sky"]["time"])
	for tile in report["tiles"]:
		files.append(tile)
		if not name_of(tile) in tiles:
			tiles.append(name_of(tile))
	if files.empty():
		problem = "%s: the run has no .glb tiles; compile with --emit glb" % path


# Takes a time such as 2026-06-21T15:20 or 2026-06-21T15:20:00Z.
func take_time(text):
	date = text.left(10)
	hour = float(text.substr(11, 2)) + float(text.substr(14, 2)) / 60.0


static func name_of(tile):
	return "%d_%d" % [tile["x"], tile["y"]]
