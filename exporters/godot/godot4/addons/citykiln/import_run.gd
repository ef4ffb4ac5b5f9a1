# Imports a run from the command line, as the dock does:
#   godot --headless --path PROJECT -s addons/citykiln/import_run.gd -- --run OUT [--to res://city] [--levels 0,1]
#     [--tiles 0_0,0_-1] [--layers ground,roads] [--collision ground,buildings] [--pixel-error 2] [--screen-px 1080]
#     [--fov-deg 75]
# Then open the project, or let `godot --headless --path PROJECT --import` import the tiles.
extends SceneTree

const Run = preload("run.gd")
const WriteCity = preload("write_city.gd")
const OPTIONS: Array[String] = ["--run", "--to", "--levels", "--tiles", "--layers", "--collision", "--pixel-error",
	"--screen-px", "--fov-deg"]

var given := {"--to": "res://city", "--collision": "", "--pixel-error": "2", "--screen-px": "1080", "--fov-deg": "75"}


func _init() -> void:
	var problem := read_options()
	if problem == "":
		var run := Run.new()
		run.read(given["--run"])
		problem = run.problem
		if problem == "":
			problem = WriteCity.new().write(run, given["--to"], choices_of(run))
	if problem != "":
		printerr("citykiln: " + problem)
	quit(0 if problem == "" else 1)


func read_options() -> String:
	var words := OS.get_cmdline_user_args()
	for i in range(0, words.size(), 2):
		if not words[i] in OPTIONS or i + 1 >= words.size():
			return "%s: expected an option and its value; the options are %s" % [words[i], ", ".join(OPTIONS)]
		given[words[i]] = words[i + 1]
	return "" if "--run" in given else "--run: expected the output folder of citykiln compile"


func choices_of(run: Run) -> Dictionary:
	return {"levels": numbers_of(given["--levels"]) if "--levels" in given else range(run.levels.size()),
		"tiles": names_of(given["--tiles"]) if "--tiles" in given else run.tiles,
		"layers": names_of(given["--layers"]) if "--layers" in given else Array(Run.LAYERS),
		"collision": names_of(given["--collision"]), "pixel_error": float(given["--pixel-error"]),
		"screen_px": float(given["--screen-px"]), "fov_deg": float(given["--fov-deg"])}


func names_of(text: String) -> Array:
	return Array(text.split(",", false))


func numbers_of(text: String) -> Array:
	var numbers := names_of(text).map(func(word: String) -> int: return word.to_int() if word.is_valid_int() else -1)
	numbers.sort()
	return numbers
