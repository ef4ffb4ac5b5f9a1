// The records of features: class, name, tags, recipe and place. They are in files by the id, so that one file is fetched for one feature.

/** Fetches a JSON file of the run. */
export async function fetchJson(url) {
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url}: ${answer.status} ${answer.statusText}`);
  return answer.json();
}

/** Fetches records and names, each file once. */
export class Records {
  /** @param {number} files The number of files: the record of an id is in file (id modulo files). */
  constructor(files) {
    this.files = files;
    this.fetched = new Map();
  }

  fetchOnce(url) {
    if (!this.fetched.has(url)) this.fetched.set(url, fetchJson(url));
    return this.fetched.get(url);
  }

  /** Returns the record of an id such as "w123"; undefined if the run has no such feature. */
  async find(id) {
    if (this.files === 0) return undefined;
    const number = BigInt(id.slice(1));
    const file = (number < 0n ? -number : number) % BigInt(this.files);
    const records = await this.fetchOnce(`page/features/${file}.json`);
    return Object.hasOwn(records, id) ? records[id] : undefined;
  }

  /** Returns the names of the map: [name, id, class, x, y], in the order of the file. */
  names() {
    return this.fetchOnce("page/names.json");
  }
}
