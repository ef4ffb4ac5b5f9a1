# Imports a run from the command line, as the dock does:
#   godot3-server --path PROJECT -s addons/citykiln/import_run.gd -- --run OUT [--to res://city] [--levels 0,1]
#     [--tiles 0_0,0_-1] [--layers ground,roads] [--collision ground,buildings] [--pixel-error 2]
# Then open the project, or let `godot3-server --path PROJECT --editor --quit` import the tiles.
extends SceneTree

const Run = preload("run.gd")
const WriteCity = preload("write_city.gd")
const OPTIONS = ["--run", "--to", "--levels", "--tiles", "--layers", "--collision", "--pixel-error"]

var given = {"--to": "res://city", "--collision": "", "--pixel-error": "2"}


func _init():
	var problem = read_options()
	if problem == "":
		var run = Run.new().read(given["--run"])
		problem = run.problem if run.problem != "" else WriteCity.new().write(run, given["--to"], choices_of(run))
	if problem != "":
		printerr("citykiln: " + problem)
	quit(0 if problem == "" else 1)


func read_options():
	var words = Array(OS.get_cmdline_args())
	words = words.slice(words.find("--") + 1, words.size() - 1) if "--" in words else []
	for i in range(0, words.size(), 2):
		if not words[i] in OPTIONS or i + 1 >= words.size():
			return "%s: expected an option and its value; the options are %s" % [words[i], PoolStringArray(OPTIONS).join(", ")]
		given[words[i]] = words[i + 1]
	return "" if "--run" in given else "--run: expected the output folder of citykiln compile"


func choices_of(run):
	return {"levels": numbers_of(given["--levels"]) if "--levels" in given else range(run.levels.size()),
		"tiles": names_of(given["--tiles"]) if "--tiles" in given else run.tiles,
		"layers": names_of(given["--layers"]) if "--layers" in given else run.LAYERS,
		"collision": names_of(given["--collision"]), "pixel_error": float(given["--pixel-error"])}


func names_of(text):
	return Array(text.split(",", false))


func numbers_of(text):
	var numbers = []
	for word in names_of(text):
		numbers.append(int(word) if word.is_valid_integer() else -1)
	numbers.sort()
	return numbers
