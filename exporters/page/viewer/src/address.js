// The address of the page follows the view, so that a reload, a bookmark or a copied address leads back to it.
const WAIT_MS = 600;

export class Address {
  /** @param {Function} write Returns the part of the address behind "#". */
  constructor(write) {
    this.write = write;
    this.last = "";
    this.timer = 0;
  }

  /** Writes the address when the view has stood still for a moment. */
  later() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.now(), WAIT_MS);
  }

  now() {
    clearTimeout(this.timer);
    const link = this.write();
    if (link === this.last) return;
    this.last = link;
    history.replaceState(null, "", `#${link}`);
  }
}
