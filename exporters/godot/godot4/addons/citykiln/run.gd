# A run of citykiln on disk: reads report.json of its folder. `problem` is empty, or one line that says what is wrong.
@tool
extends RefCounted

const LAYERS: Array[String] = ["ground", "roads", "water", "buildings", "structures", "props", "plants"]

var folder := ""
var problem := ""
# tolerance and measured error in metres of each level, finest first
var levels := []
# of each file: "file" relative to the folder, "x", "y", "level"
var files := []
# names such as "0_-1"
var tiles := []
var attribution := []
var tile_m := 0.0


func read(of_folder: String) -> void:
	folder = of_folder
	var path := folder.path_join("report.json")
	if not FileAccess.file_exists(path):
		problem = "%s: no such file; expected the output folder of citykiln compile" % path
		return
	var json := JSON.new()
	if json.parse(FileAccess.get_file_as_string(path)) != OK or not json.data is Dictionary:
		problem = "%s:%d: expected JSON of citykiln" % [path, json.get_error_line() + 1]
		return
	take(json.data, path)


func take(report: Dictionary, path: String) -> void:
	for key in ["target", "levels", "tiles", "attribution", "tile_m"]:
		if not key in report:
			problem = "%s: lacks \"%s\"; expected the report of citykiln compile" % [path, key]
			return
	if not report["target"] in ["godot", "generic"] or report.get("compress", "none") != "none":
		problem = "%s: the tiles are for %s, compressed by %s; compile with --target godot and without --compress" % [
			path, report["target"], report.get("compress", "none")]
		return
	levels = report["levels"]
	attribution = report["attribution"]
	tile_m = report["tile_m"]
	for tile: Dictionary in report["tiles"]:
		files.append(tile)
		if not name_of(tile) in tiles:
			tiles.append(name_of(tile))
	if files.is_empty():
		problem = "%s: the run has no .glb tiles; compile with --emit glb" % path


static func name_of(tile: Dictionary) -> String:
	return "%d_%d" % [tile["x"], tile["y"]]
