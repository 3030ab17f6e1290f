/** Saves what is at an address, under its last name. */
export function downloadFile(address: string): void {
  const link = document.createElement("a");
  link.href = address;
  link.download = decodeURIComponent(address.split("/").at(-1)!);
  link.click();
}
